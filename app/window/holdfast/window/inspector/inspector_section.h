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
class QFormLayout;
class QLabel;

namespace holdfast {

/// Shows the constraints of some rows, reads them from the editor whenever it is told to, and edits all of them at
/// once.
class InspectorSection : public QWidget {
  Q_OBJECT

 public:
  /// `editor` stays alive as long as this.
  explicit InspectorSection(Editor& editor, QWidget* parent = nullptr);

  /// Whether the section has something to say of the constraint.
  [[nodiscard]] virtual bool fits(const Constraint& constraint) const = 0;

  /// Shows these rows, one or more, which all fit.
  void inspect(const Rows& rows);

  /// Titles of all sections are equally wide, so that fields stand below one another.
  [[nodiscard]] int titleWidth();
  void setTitleWidth(int width);

 Q_SIGNALS:
  /// An edit that makes no sense, and why.
  void refused(const QString& reason);

 protected:
  virtual void refresh() = 0;
  /// Whether the state or the rows are others than when this was asked before. Where they are not, lines that only make
  /// sense together keep what was typed into them.
  [[nodiscard]] bool isNews();
  void hideEvent(QHideEvent* event) override;

  [[nodiscard]] Editor& editor() const { return editor_; }
  [[nodiscard]] const Rows& rows() const { return rows_; }
  [[nodiscard]] const Constraint& constraint(Index row) const { return editor_.list().constraints[row]; }
  /// "P1", "3 constraints".
  [[nodiscard]] QString subject() const { return subjectOf(editor_, rows_); }
  /// `change` may throw `InputError`, which is refused with its reason.
  void change(const QString& name, const Change& change);

  /// What `read` gives for all rows; nothing where they differ, or where it gives nothing.
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

  [[nodiscard]] QFormLayout& form() { return *form_; }
  /// A line of text that can be selected and copied.
  [[nodiscard]] QLabel* addText(const QString& title, const QString& name);
  /// `spoken` is the title for people who hear what they cannot see, where the one that is shown does not say it all.
  [[nodiscard]] VectorEdit* addVector(const QString& title, const QString& name, const QString& spoken = {});
  [[nodiscard]] NumberEdit* addNumber(const QString& title, const QString& name);
  [[nodiscard]] QComboBox* addChoice(const QString& title, const QString& name, const QString& spoken,
                                     const QStringList& choices);
  /// A tool tip for a field that stands in the form, on its title too: lines of numbers show all their digits instead.
  void explain(QWidget* field, const QString& text);
  /// Shows or hides a field with its title.
  void setFieldVisible(QWidget* field, bool isVisible);

 private:
  struct Field {
    QWidget* title = nullptr;
    QWidget* field = nullptr;
  };

  void collectRows();

  Editor& editor_;
  Rows rows_;
  std::shared_ptr<const DocumentState> reported_;  // of the latest news
  Rows reportedRows_;
  QFormLayout* form_;
  std::vector<Field> fields_;  // all of them, in order; those in the form are visible
};

/// "x", "y", "z".
[[nodiscard]] QString axisText(int axis);

}  // namespace holdfast
