#include <holdfast/window/inspector/inspector_section.h>
#include <holdfast/window/model/at_rest.h>
#include <holdfast/window/text/constraint_text.h>

namespace holdfast {
namespace {

class RelativeSection : public SectionOf<RelativeConstraint> {
 public:
  explicit RelativeSection(Editor& editor) : SectionOf(editor, tr("Places"))
  {
    addPlace(tr("From"), "relativeFrom", &RelativeConstraint::from);
    addPlace(tr("To"), "relativeTo", &RelativeConstraint::to);
    bindChoice(
        tr("&Keeps"), "relativeWay", tr("Which vector between the places is kept"),
        {tr("its vector at rest, rotated with the surface"), tr("an offset of its own")},
        [](const RelativeConstraint& relative) { return relative.offset ? 1.0 : 0.0; },
        [this](int way) { chooseWay(way); });
    explain(bindVector(
                tr("&Offset"), "relativeOffset",
                [this](const RelativeConstraint& relative) -> std::optional<Vector3> {
                  if (relative.offset) return relative.offset;
                  const std::optional<Vector3> from = restPlace(this->editor(), relative.from);
                  const std::optional<Vector3> to = restPlace(this->editor(), relative.to);
                  return from && to ? std::optional<Vector3>(*from - *to) : std::nullopt;
                },
                tr("set the offset of %1 to %2 = %3"),
                [this](RelativeConstraint& relative, int axis, double number) {
                  relative.offset = offsetOf(relative);
                  (*relative.offset)[axis] = number;
                },
                WithoutValue::Shown),
            tr("The place “From” minus the place “To”. Typing makes it an offset of its own"));
  }

 private:
  void addPlace(const QString& title, const QString& name, SurfaceLocation RelativeConstraint::*place)
  {
    QLabel* label = addText(title, name);
    addRefresh([=, this] {
      setFieldVisible(label, rows().size() == 1);
      const std::optional<Vector3> rest = restPlace(editor(), what().*place);
      const QString where = rest ? tr("at rest %1").arg(placeText(*rest, editor().lengthStyle()))
                                 : tr("nowhere: the mesh has no such place");
      label->setText(locationText(what().*place) + '\n' + where);
      label->setToolTip(rest ? exactText(*rest) : QString());
    });
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
  }
};

}  // namespace

Sections newRelativeSections(Editor& editor)
{
  return {new RelativeSection(editor)};
}

}  // namespace holdfast
