#include <holdfast/constraints/mirror_pairs.h>
#include <holdfast/window/inspector/guide_section.h>
#include <holdfast/window/model/at_rest.h>

namespace holdfast {
namespace {

class MirrorSection : public SectionOf<MirrorConstraint> {
 public:
  explicit MirrorSection(Editor& editor) : SectionOf(editor, tr("Mirror"))
  {
    bindVector(
        tr("Th&rough"), "mirrorThrough", [](const MirrorConstraint& mirror) { return mirror.point; },
        tr("lead the mirror of %1 through %2 = %3"),
        [](MirrorConstraint& mirror, int axis, double number) { mirror.point[axis] = number; });
    bindVector(
        tr("&Normal"), "mirrorNormal", [](const MirrorConstraint& mirror) { return mirror.normal; },
        tr("rotate the mirror of %1 to %2 = %3"),
        [](MirrorConstraint& mirror, int axis, double number) { setDirection(mirror.normal, axis, number); });
    explain(
        bindNumber(
            tr("&Tolerance"), "mirrorTolerance", [this](const MirrorConstraint& mirror) { return toleranceOf(mirror); },
            tr("find partners of %1 within %2"),
            [](MirrorConstraint& mirror, double number) {
              if (number < 0) throw InputError({}, "a distance cannot be below 0");
              mirror.tolerance = number;
            }),
        tr("How far a vertex may be from the image of its partner at rest"));
    partners_ = addText(tr("Partners"), "mirrorPartners");
  }

 private:
  void refresh() override
  {
    SectionOf::refresh();
    setFieldVisible(partners_, rows().size() == 1);
    // A drag moves no vertex at rest.
    if (rows().size() == 1 && isNews() && !(editor().history().isInGesture() && !partners_->text().isEmpty()))
      partners_->setText(partnersText());
  }

  [[nodiscard]] double toleranceOf(const MirrorConstraint& mirror) const
  {
    const Model* model = editor().model().get();
    return mirror.tolerance.value_or(model == nullptr ? 0 : kMirrorTolerance * model->solverMesh.diagonal);
  }

  [[nodiscard]] QString partnersText()
  {
    const MirrorConstraint& mirror = what();
    if (!mirror.pairs.empty()) return countText(static_cast<Index>(mirror.pairs.size()), "1 listed", "%1 listed");
    const FoundVertices found = findVertices(editor(), mirror.select);
    if (found.vertices.empty()) return QString::fromStdString(found.reason);
    const Positions& rest = editor().model()->mesh.positions;
    const MirrorPairs pairs = mirrorPairs(rest, found.vertices, mirror.point, mirror.normal, toleranceOf(mirror));
    QString text = countText(static_cast<Index>(pairs.pairs.size()), "1 pair", "%1 pairs");
    if (!pairs.onPlane.empty()) text += tr(", %1 on the plane").arg(pairs.onPlane.size());
    if (!pairs.unpaired.empty()) text += tr(", %1 without a partner").arg(pairs.unpaired.size());
    return text;
  }

  QLabel* partners_ = nullptr;
};

}  // namespace

Sections newMirrorSections(Editor& editor)
{
  return {new MirrorSection(editor)};
}

}  // namespace holdfast
