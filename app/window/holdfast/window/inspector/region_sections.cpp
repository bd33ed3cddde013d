#include "holdfast/window/inspector/region_sections.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

// Each is a pass over all vertices, at every change of the selection.
constexpr std::size_t kMostCounted = 50;

}  // namespace

VerticesSection::VerticesSection(Editor& editor, QWidget* parent) : InspectorSection(editor, parent), vertices_(editor)
{
  how_ = addText(tr("Selects"), "verticesHow");
  count_ = addText(tr("Holds"), "verticesCount");
  select_ = new QPushButton(tr("Select Its &Vertices"), this);
  select_->setObjectName("verticesSelect");
  form().addRow(QString(), select_);
  connect(select_, &QPushButton::clicked, this, &VerticesSection::selectThem);
}

bool VerticesSection::fits(const Constraint& constraint) const
{
  return selectionOf(constraint) != nullptr;
}

void VerticesSection::refresh()
{
  setFieldVisible(how_, rows().size() == 1);
  if (rows().size() == 1) how_->setText(selectionText(*selectionOf(constraint(rows().front()))));
  // A drag moves what is selected and selects nothing else.
  const bool isSame =
      counted_ == editor().history().state() || (counted_ != nullptr && editor().history().isInGesture());
  if (!isSame || countedRows_ != rows()) count();
}

void VerticesSection::count()
{
  counted_ = editor().history().state();
  countedRows_ = rows();
  select_->setEnabled(true);
  if (rows().size() > kMostCounted) return count_->setText(tr("not counted for so many constraints"));
  Index count = 0;
  QString reason;
  for (const Index row : rows()) {
    const SelectedVertices::Found found = vertices_.of(*selectionOf(constraint(row)));
    count += static_cast<Index>(found.vertices.size());
    if (!found.reason.empty()) reason = quoted(constraint(row).name) + ": " + QString::fromStdString(found.reason);
  }
  const QString number = count == 1 ? tr("1 vertex") : tr("%1 vertices").arg(countText(count));
  count_->setText(reason.isEmpty() ? number : reason);
  select_->setEnabled(reason.isEmpty());
}

void VerticesSection::selectThem()
{
  std::vector<Index> all;
  for (const Index row : rows()) {
    const SelectedVertices::Found found = vertices_.of(*selectionOf(constraint(row)));
    all.insert(all.end(), found.vertices.begin(), found.vertices.end());
  }
  editor().selectVertices(std::move(all));
}

RelativeSection::RelativeSection(Editor& editor, QWidget* parent) : InspectorSection(editor, parent), places_(editor)
{
  from_ = addText(tr("From"), "relativeFrom");
  to_ = addText(tr("To"), "relativeTo");
  way_ = addChoice(tr("&Keeps"), "relativeWay", tr("How the places lie to each other"),
                   {tr("its vector at rest, turning with the surface"), tr("an offset of its own")});
  offset_ = addVector(tr("&Offset"), "relativeOffset");
  explain(offset_, tr("The place “From” minus the place “To”. What is typed is an offset of its own"));
  connect(way_, qOverload<int>(&QComboBox::activated), this, &RelativeSection::chooseWay);
  connect(offset_, &VectorEdit::entered, this, &RelativeSection::setOffset);
}

bool RelativeSection::fits(const Constraint& constraint) const
{
  return std::holds_alternative<RelativeConstraint>(constraint.what);
}

void RelativeSection::refresh()
{
  const auto relative = [this](Index row) -> const RelativeConstraint& {
    return std::get<RelativeConstraint>(constraint(row).what);
  };
  const bool isOne = rows().size() == 1;
  setFieldVisible(from_, isOne);
  setFieldVisible(to_, isOne);
  if (isOne) showPlace(*from_, relative(rows().front()).from);
  if (isOne) showPlace(*to_, relative(rows().front()).to);
  const auto hasOffset = [&](Index row) { return relative(row).offset.has_value(); };
  const bool areOffsets = std::all_of(rows().begin(), rows().end(), hasOffset);
  const bool areKept = std::none_of(rows().begin(), rows().end(), hasOffset);
  way_->setCurrentIndex(areOffsets ? 1 : areKept ? 0 : -1);
  offset_->setNumbers(commonVector([this](const Constraint& constraint) -> std::optional<Vector3> {
    const RelativeConstraint& what = std::get<RelativeConstraint>(constraint.what);
    if (what.offset) return what.offset;
    const std::optional<Vector3> from = places_.of(what.from);
    const std::optional<Vector3> to = places_.of(what.to);
    return from && to ? std::optional<Vector3>(*from - *to) : std::nullopt;
  }));
}

void RelativeSection::showPlace(QLabel& label, const SurfaceLocation& location)
{
  const std::optional<Vector3> rest = places_.of(location);
  const QString place = rest ? tr("at rest %1").arg(roundedText(*rest)) : tr("nowhere: the mesh has no such place");
  label.setText(locationText(location) + '\n' + place);
  label.setToolTip(rest ? exactText(*rest) : QString());
}

Vector3 RelativeSection::offsetOf(const RelativeConstraint& relative)
{
  return relative.offset ? *relative.offset : Vector3(places_.require(relative.from) - places_.require(relative.to));
}

void RelativeSection::chooseWay(int way)
{
  const QString name = way == 0 ? tr("keep the vector of %1") : tr("give %1 an offset");
  change(name.arg(subject()), [&](Constraint constraint) -> std::optional<Constraint> {
    RelativeConstraint& relative = std::get<RelativeConstraint>(constraint.what);
    if (relative.offset.has_value() == (way == 1)) return std::nullopt;
    relative.offset = way == 1 ? std::optional(offsetOf(relative)) : std::nullopt;
    return constraint;
  });
  refresh();
}

void RelativeSection::setOffset(int axis, double value)
{
  change(tr("set the offset of %1 to %2 = %3").arg(subject(), axisText(axis), exactText(value)),
         [&](Constraint constraint) {
           RelativeConstraint& relative = std::get<RelativeConstraint>(constraint.what);
           Vector3 offset = offsetOf(relative);
           offset[axis] = value;
           relative.offset = offset;
           return constraint;
         });
}

}  // namespace holdfast
