#include <algorithm>
#include <memory>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

// Each one takes a pass over all vertices at every change of the selection.
constexpr std::size_t kMostCounted = 50;

Index ringsOf(const Selection& selection)
{
  const auto* grown = std::get_if<Grown>(&selection.what);
  return grown == nullptr ? 0 : grown->rings;
}

Selection withRings(const Selection& selection, Index rings)
{
  const auto* grown = std::get_if<Grown>(&selection.what);
  const Selection& part = grown == nullptr ? selection : *grown->part;
  return rings == 0 ? part : Selection{Grown{std::make_shared<const Selection>(part), rings}};
}

class VerticesSection : public InspectorSection {
 public:
  explicit VerticesSection(Editor& editor) : InspectorSection(editor, tr("Vertices"))
  {
    how_ = addText(tr("Selects"), "verticesHow");
    rings_ = addNumber(tr("Rings"), "verticesRings");
    explain(rings_, tr("Rings of vertices around them that are held as well: one keeps the tangents of a border"));
    connect(rings_, &NumberEdit::entered, this, &VerticesSection::setRings);
    count_ = addText(tr("Holds"), "verticesCount");
    select_ = named(new QPushButton(tr("Select its ver&tices"), this), "verticesSelect");
    addRow(QStringLiteral(""), select_);
    connect(select_, &QPushButton::clicked, this, &VerticesSection::selectThem);
  }

  bool fits(const Constraint& constraint) const override { return selectionOf(constraint) != nullptr; }

 private:
  void refresh() override
  {
    setFieldVisible(how_, rows().size() == 1);
    if (rows().size() == 1) how_->setText(selectionText(*selectionOf(constraint(rows().front()))));
    setFieldVisible(rings_, std::ranges::all_of(rows(), [this](Index row) { return mayHaveRings(constraint(row)); }));
    rings_->setNumber(
        common([](const Constraint& each) { return std::optional(static_cast<double>(ringsOf(*selectionOf(each)))); }));
    // A drag moves what is selected and selects nothing else.
    if (isNews() && !(editor().history().isInGesture() && !count_->text().isEmpty())) count();
  }

  static bool mayHaveRings(const Constraint& constraint)
  {
    return std::holds_alternative<FixedConstraint>(constraint.what) ||
           std::holds_alternative<HandleConstraint>(constraint.what);
  }

  void setRings(double typed)
  {
    change(editName(tr("hold %1 with %2 rings"), {roundedText(typed)}), [&](Constraint constraint) {
      const Index rings = wholeNumber(typed, 0, "is no number of rings");
      if (auto* fixed = std::get_if<FixedConstraint>(&constraint.what)) fixed->select = withRings(fixed->select, rings);
      if (auto* handle = std::get_if<HandleConstraint>(&constraint.what)) {
        handle->select = withRings(handle->select, rings);
        if (const auto error = validateHandle(*handle)) throw InputError({}, error->reason);
      }
      return std::optional(constraint);
    });
  }

  void count()
  {
    select_->setEnabled(true);
    if (rows().size() > kMostCounted) return count_->setText(tr("not counted for so many constraints"));
    Index count = 0;
    QString reason;
    for (const Index row : rows()) {
      const FoundVertices found = findVertices(editor(), *selectionOf(constraint(row)));
      count += static_cast<Index>(found.vertices.size());
      if (!found.reason.empty()) reason = quoted(constraint(row).name) + ": " + QString::fromStdString(found.reason);
    }
    const QString number = countText(count, "1 vertex", "%1 vertices");
    count_->setText(reason.isEmpty() ? number : reason);
    select_->setEnabled(reason.isEmpty());
  }

  void selectThem()
  {
    std::vector<Index> all;
    for (const Index row : rows()) {
      const FoundVertices found = findVertices(editor(), *selectionOf(constraint(row)));
      all.insert(all.end(), found.vertices.begin(), found.vertices.end());
    }
    editor().selectVertices(std::move(all));
  }

  QLabel* count_ = nullptr;
  QLabel* how_ = nullptr;
  NumberEdit* rings_ = nullptr;
  QPushButton* select_ = nullptr;
};

}  // namespace

Sections newVerticesSections(Editor& editor)
{
  return {new VerticesSection(editor)};
}

}  // namespace holdfast
