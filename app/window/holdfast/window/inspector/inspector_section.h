#pragma once
/// A section is one part of the inspector. It shows and edits what some kinds of constraints have in common.

#include <QComboBox>
#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <holdfast/numbers/same_bits.h>
#include <holdfast/window/controls/number_edit.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

/// The section shows the constraints of some rows and edits all of them at once.
class InspectorSection : public QWidget {
  Q_OBJECT

 public:
  InspectorSection(Editor& editor, const QString& title);

  [[nodiscard]] virtual bool fits(const Constraint& constraint) const = 0;
  /// Shows the constraints of `rows`: one or more, which all fit.
  void inspect(const Rows& rows);

  /// Returns the width that the titles need. Titles of all sections are equally wide, so that fields stand below one
  /// another.
  [[nodiscard]] int titleWidth() const;
  void setTitleWidth(int width)
  {
    for (QLabel* title : titles_) title->setMinimumWidth(width);
  }

 Q_SIGNALS:
  void refused(const QString& reason);
  /// What was refused is not there any more.
  void righted();

 protected:
  virtual void refresh()
  {
    for (const auto& refresh : refreshes_) refresh();
  }
  /// Tells whether the document or the rows have changed since the last call. If not, lines that only make sense
  /// together keep what was typed into them.
  [[nodiscard]] bool isNews();
  void hideEvent(QHideEvent* event) override
  {
    reported_.reset();
    QWidget::hideEvent(event);
  }
  [[nodiscard]] Editor& editor() const { return editor_; }
  [[nodiscard]] const Rows& rows() const { return rows_; }
  [[nodiscard]] const Constraint& constraint(Index row) const { return editor_.list().constraints[row]; }
  [[nodiscard]] QString subject() const { return subjectOf(editor_, rows_); }
  /// Changes the constraints by one edit. `change` may throw `InputError`; the section then emits `refused` with its
  /// reason.
  void change(const QString& name, const Change& change);

  /// Returns what `read` gives for all rows. It returns nothing if the rows differ, or if `read` gives nothing for one.
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

  /// Adds a field below the others. A field without a title takes the whole width.
  void addRow(const QString& title, QWidget* field);
  [[nodiscard]] QLabel* addText(const QString& title, const QString& name);
  /// Adds a field for a vector. `spoken` is the title for screen readers, if the title that is shown does not say it
  /// all.
  VectorEdit* addVector(const QString& title, const QString& name, const QString& spoken = {});
  NumberEdit* addNumber(const QString& title, const QString& name);
  void addRefresh(std::function<void()> refresh) { refreshes_.push_back(std::move(refresh)); }
  /// Gives a field and its title a tool tip. Lines of numbers show all their digits instead.
  void explain(QWidget* field, const QString& text);
  [[nodiscard]] static QLabel& titleOf(QWidget* field)
  {
    return *static_cast<QLabel*>(field->parentWidget()->layout()->itemAt(0)->widget());
  }
  static void setFieldVisible(QWidget* field, bool isVisible) { field->parentWidget()->setVisible(isVisible); }
  /// Returns the name of an edit: `pattern` with the subject and, if the pattern has room for them, `words`.
  [[nodiscard]] QString editName(const QString& pattern, const QStringList& words) const;

 private:
  Editor& editor_;
  Rows rows_;
  std::shared_ptr<const DocumentState> reported_;  // of the latest news
  Rows reportedRows_;
  QVBoxLayout* lines_;
  std::vector<QLabel*> titles_;
  std::vector<std::function<void()>> refreshes_;
};

/// A section of constraints of one kind. A field is hidden unless its `read` gives something for each constraint.
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
  [[nodiscard]] const What& what() const { return what(rows().front()); }

  /// Calls `edit` for each row. It changes the row, or returns false to leave it as it is.
  template <class Edit>
  void edit(const QString& name, Edit edit)
  {
    change(name, [&](Constraint constraint) -> std::optional<Constraint> {
      if (!edit(std::get<What>(constraint.what))) return std::nullopt;
      return constraint;
    });
  }

  enum class WithoutValue { Hidden, Shown };

  /// Adds a field for the vector that `read(what)` gives. `write(what, axis, number)` sets one number in it.
  template <class Read, class Write>
  VectorEdit* bindVector(const QString& title, const QString& name, Read read, const QString& pattern, Write write,
                         WithoutValue without = WithoutValue::Hidden)
  {
    VectorEdit* field = addVector(title, name);
    const auto ofConstraint = [=](const Constraint& c) -> std::optional<Vector3> {
      return read(std::get<What>(c.what));
    };
    addRefresh([=, this] {
      if (without == WithoutValue::Hidden) showWhileGiven(field, read);
      field->setNumbers(commonVector(ofConstraint));
    });
    connect(field, &VectorEdit::entered, this, [=, this](int axis, double number) {
      edit(editName(pattern, {axisText(axis), exactText(number)}), [&](What& what) {
        write(what, axis, number);
        return true;
      });
    });
    return field;
  }

  template <class Read, class Write>
  NumberEdit* bindNumber(const QString& title, const QString& name, Read read, const QString& pattern, Write write)
  {
    NumberEdit* field = addNumber(title, name);
    addRefresh([=, this] {
      showWhileGiven(field, read);
      field->setNumber(commonOf(read));
    });
    connect(field, &NumberEdit::entered, this, [=, this](double number) {
      edit(editName(pattern, {exactText(number)}), [&](What& what) {
        write(what, number);
        return true;
      });
    });
    return field;
  }

  template <class Read>
  QComboBox* bindChoice(const QString& title, const QString& name, const QString& spoken, const QStringList& choices,
                        Read read, const std::function<void(int)>& choose)
  {
    auto* field = named(new QComboBox(this), name, spoken);
    field->addItems(choices);
    // Else its longest entry would make narrow panels scroll sideways.
    field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(field, qOverload<int>(&QComboBox::activated), this, [this, choose](int choice) {
      choose(choice);
      refresh();
    });
    addRow(title, field);
    addRefresh([=, this] {
      showWhileGiven(field, read);
      field->setCurrentIndex(static_cast<int>(commonOf(read).value_or(-1)));
    });
    return field;
  }

  template <class Read>
  void showWhileGiven(QWidget* field, Read read)
  {
    setFieldVisible(field, std::all_of(rows().begin(), rows().end(),
                                       [&](Index row) { return std::optional(read(what(row))).has_value(); }));
  }

 private:
  template <class Read>
  [[nodiscard]] std::optional<double> commonOf(Read read) const
  {
    return common([&](const Constraint& c) -> std::optional<double> { return read(std::get<What>(c.what)); });
  }
};

/// Returns what was typed, if it is a whole number from `least` on. Else it throws `InputError` with `reason`.
[[nodiscard]] Index wholeNumber(double typed, double least, const std::string& reason);

/// Makes the panel, which shows the selected constraints of an editor. Of several it shows what they have in common.
/// The editor outlives the panel.
[[nodiscard]] QWidget* newInspectorPanel(Editor& editor);

// The sections of the inspector. A layout takes them; `editor` outlives them.
using Sections = std::vector<InspectorSection*>;

/// Makes sections that show where one point lies (ids and weights), and where points go: to a place, or by a shift.
[[nodiscard]] Sections newPointSections(Editor& editor);
/// Makes a section that shows how near points come to their targets.
[[nodiscard]] Sections newToleranceSections(Editor& editor);
/// Makes a section that shows how many vertices fixed, rigid and handle constraints hold.
[[nodiscard]] Sections newVerticesSections(Editor& editor);
/// Makes sections that show how handles turn, where they go, and their frames. They also show what each vertex that a
/// handle lists has of its own.
[[nodiscard]] Sections newHandleSections(Editor& editor);
/// Makes a section that shows on what the vertices of slide constraints stay, and whether that may shift.
[[nodiscard]] Sections newSlideSections(Editor& editor);
/// Makes a section that shows across which plane mirror constraints keep the surface symmetric, and with which
/// partners.
[[nodiscard]] Sections newMirrorSections(Editor& editor);
/// Makes sections that show which places relative constraints keep together, and how.
[[nodiscard]] Sections newRelativeSections(Editor& editor);
/// Makes sections that show whether constraints hold and how hard they pull. Of several constraints they show the
/// largest values.
[[nodiscard]] Sections newOutcomeSections(Editor& editor);

/// Makes the sections of the panel, from its top.
inline constexpr std::array kNewSections{newPointSections,    newToleranceSections, newVerticesSections,
                                         newHandleSections,   newSlideSections,     newMirrorSections,
                                         newRelativeSections, newOutcomeSections};

}  // namespace holdfast
