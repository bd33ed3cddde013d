#pragma once
/// \file
/// One part of the inspector: what some kinds of constraints have in common, shown and edited.

#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include <holdfast/io/text/number_text.h>
#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/model/editor.h>

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace holdfast {

/// Shows the constraints of some rows and edits all of them at once.
class InspectorSection : public QWidget {
  Q_OBJECT

 public:
  /// `editor` stays alive as long as this.
  explicit InspectorSection(Editor& editor);

  /// Whether the section applies to the constraint.
  [[nodiscard]] virtual bool fits(const Constraint& constraint) const = 0;
  /// Reads these rows, one or more, which all fit, from the editor and shows them.
  void inspect(const Rows& rows);

  /// Titles of all sections are equally wide, so that fields stand below one another.
  [[nodiscard]] int titleWidth() const;
  void setTitleWidth(int width);

 Q_SIGNALS:
  /// An edit that makes no sense, and why.
  void refused(const QString& reason);

 protected:
  virtual void refresh() = 0;
  /// Whether the state or the rows differ from those of the last call. If not, lines that only make sense together keep
  /// what was typed into them.
  [[nodiscard]] bool isNews();
  void hideEvent(QHideEvent* event) override;
  [[nodiscard]] Editor& editor() const { return editor_; }
  [[nodiscard]] const Rows& rows() const { return rows_; }
  [[nodiscard]] const Constraint& constraint(Index row) const { return editor_.list().constraints[row]; }
  /// "P1", "3 constraints".
  [[nodiscard]] QString subject() const { return subjectOf(editor_, rows_); }
  /// `change` may throw `InputError`, which is refused with its reason.
  void change(const QString& name, const Change& change);

  /// What `read` gives for all rows; nothing if they differ or it gives nothing.
  template <class Read>
  [[nodiscard]] std::optional<double> common(Read read) const
  {
    std::optional<double> first = read(constraint(rows_.front()));
    for (const Index row : rows_) {
      const std::optional<double> next = read(constraint(row));
      if (!first || !next || !hasSameBits(*first, *next)) return std::nullopt;
    }
    return first;
  }

  /// The same for three numbers: `read` gives an optional vector.
  template <class Read>
  [[nodiscard]] VectorEdit::Numbers commonVector(Read read) const
  {
    VectorEdit::Numbers numbers;
    for (Index axis = 0; axis < 3; ++axis)
      numbers[static_cast<std::size_t>(axis)] = common([&](const Constraint& constraint) -> std::optional<double> {
        const std::optional<Vector3> vector = read(constraint);
        return vector ? std::optional((*vector)[axis]) : std::nullopt;
      });
    return numbers;
  }

  /// A field below the others, over the whole width if it has no title.
  void addRow(const QString& title, QWidget* field);
  /// A line of text that can be selected and copied.
  [[nodiscard]] QLabel* addText(const QString& title, const QString& name);
  /// `spoken` is the title for screen readers, if the one that is shown does not say it all.
  [[nodiscard]] VectorEdit* addVector(const QString& title, const QString& name, const QString& spoken = {});
  [[nodiscard]] NumberEdit* addNumber(const QString& title, const QString& name);
  /// `choose` gets the entry that the user chose.
  [[nodiscard]] QComboBox* addChoice(const QString& title, const QString& name, const QString& spoken,
                                     const QStringList& choices, const std::function<void(int)>& choose);
  /// A tool tip for a field and its title. Lines of numbers show all their digits instead.
  void explain(QWidget* field, const QString& text);
  [[nodiscard]] static QLabel& titleOf(QWidget* field);
  /// Shows or hides a field with its title.
  static void setFieldVisible(QWidget* field, bool isVisible) { field->parentWidget()->setVisible(isVisible); }

 private:
  Editor& editor_;
  Rows rows_;
  std::shared_ptr<const DocumentState> reported_;  // of the latest news
  Rows reportedRows_;
  QVBoxLayout* lines_;
  std::vector<QLabel*> titles_;
};

/// A section of constraints of one kind.
template <class What>
class SectionOf : public InspectorSection {
 public:
  using InspectorSection::InspectorSection;

  [[nodiscard]] bool fits(const Constraint& constraint) const override
  {
    return std::holds_alternative<What>(constraint.what);
  }

 protected:
  [[nodiscard]] const What& what(Index row) const { return std::get<What>(constraint(row).what); }
  /// That of the first row.
  [[nodiscard]] const What& what() const { return what(rows().front()); }

  template <class Read>
  [[nodiscard]] std::optional<double> commonOf(Read read) const
  {
    return common([&](const Constraint& c) -> std::optional<double> { return read(std::get<What>(c.what)); });
  }

  template <class Read>
  [[nodiscard]] VectorEdit::Numbers commonVectorOf(Read read) const
  {
    return commonVector([&](const Constraint& c) -> std::optional<Vector3> { return read(std::get<What>(c.what)); });
  }

  /// `edit` changes each row, or returns false to leave it as it is.
  template <class Edit>
  void edit(const QString& name, Edit edit)
  {
    change(name, [&](Constraint constraint) -> std::optional<Constraint> {
      return edit(std::get<What>(constraint.what)) ? std::optional(constraint) : std::nullopt;
    });
  }
};

/// "x", "y", "z".
[[nodiscard]] QString axisText(int axis);

}  // namespace holdfast
