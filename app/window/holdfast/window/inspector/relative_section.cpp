#include <QComboBox>
#include <QLabel>
#include <algorithm>

#include <holdfast/window/inspector/sections.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/constraint_text.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

class RelativeSection : public SectionOf<RelativeConstraint> {
 public:
  explicit RelativeSection(Editor& editor) : SectionOf(editor)
  {
    from_ = addText(tr("From"), "relativeFrom");
    to_ = addText(tr("To"), "relativeTo");
    way_ = addChoice(tr("&Keeps"), "relativeWay", tr("Which vector between the places is kept"),
                     {tr("its vector at rest, turning with the surface"), tr("an offset of its own")},
                     [this](int way) { chooseWay(way); });
    offset_ = addVector(tr("&Offset"), "relativeOffset");
    explain(offset_, tr("The place “From” minus the place “To”. Typing makes it an offset of its own"));
    connect(offset_, &VectorEdit::entered, this, &RelativeSection::setOffset);
  }

 private:
  void refresh() override
  {
    const bool isOne = rows().size() == 1;
    for (QLabel* label : {from_, to_}) setFieldVisible(label, isOne);
    if (isOne) showPlace(*from_, what().from);
    if (isOne) showPlace(*to_, what().to);

    const auto hasOffset = [&](Index row) { return what(row).offset.has_value(); };
    const bool areOffsets = std::all_of(rows().begin(), rows().end(), hasOffset);
    const bool areKept = std::none_of(rows().begin(), rows().end(), hasOffset);
    way_->setCurrentIndex(areOffsets ? 1 : areKept ? 0 : -1);
    offset_->setNumbers(commonVectorOf([this](const RelativeConstraint& relative) -> std::optional<Vector3> {
      if (relative.offset) return relative.offset;
      const std::optional<Vector3> from = restPlace(editor(), relative.from);
      const std::optional<Vector3> to = restPlace(editor(), relative.to);
      return from && to ? std::optional<Vector3>(*from - *to) : std::nullopt;
    }));
  }

  void showPlace(QLabel& label, const SurfaceLocation& location)
  {
    const std::optional<Vector3> rest = restPlace(editor(), location);
    const QString place = rest ? tr("at rest %1").arg(roundedText(*rest)) : tr("nowhere: the mesh has no such place");
    label.setText(locationText(location) + '\n' + place);
    label.setToolTip(rest ? exactText(*rest) : QString());
  }

  /// The vector that is kept, in numbers.
  Vector3 offsetOf(const RelativeConstraint& relative)
  {
    if (relative.offset) return *relative.offset;
    return requireRestPlace(editor(), relative.from) - requireRestPlace(editor(), relative.to);
  }

  void chooseWay(int way)
  {
    const QString name = way == 0 ? tr("keep the vector of %1") : tr("give %1 an offset");
    edit(name.arg(subject()), [&](RelativeConstraint& relative) {
      if (relative.offset.has_value() == (way == 1)) return false;
      relative.offset = way == 1 ? std::optional(offsetOf(relative)) : std::nullopt;
      return true;
    });
    refresh();
  }

  void setOffset(int axis, double value)
  {
    const QString name = tr("set the offset of %1 to %2 = %3");
    edit(name.arg(subject(), axisText(axis), exactText(value)), [&](RelativeConstraint& relative) {
      relative.offset = offsetOf(relative);
      (*relative.offset)[axis] = value;
      return true;
    });
  }

  QLabel* from_ = nullptr;
  QLabel* to_ = nullptr;
  QComboBox* way_ = nullptr;
  VectorEdit* offset_ = nullptr;
};

}  // namespace

InspectorSection* newRelativeSection(Editor& editor)
{
  return new RelativeSection(editor);
}

}  // namespace holdfast
