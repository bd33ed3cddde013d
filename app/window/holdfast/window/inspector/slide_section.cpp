#include <array>
#include <utility>

#include <holdfast/constraints/fitted_guides.h>
#include <holdfast/window/inspector/guide_section.h>
#include <holdfast/window/model/at_rest.h>

namespace holdfast {
namespace {

using Guide = decltype(SlideConstraint::on);

/// In the order in which they are offered.
enum GuideWay { OnePlane, PlaneOfEach, OneLine, LineOfEach, PlaneThatFits, LineThatFits, OneMesh };

GuideWay wayOf(const Guide& guide)
{
  if (const auto* plane = std::get_if<OnPlane>(&guide)) return plane->point ? OnePlane : PlaneOfEach;
  if (const auto* line = std::get_if<OnLine>(&guide)) return line->point ? OneLine : LineOfEach;
  if (std::holds_alternative<OnMesh>(guide)) return OneMesh;
  return std::holds_alternative<FittedPlane>(guide) ? PlaneThatFits : LineThatFits;
}

/// `guide` in another way; planes and lines begin with the ones that fit the vertices at rest.
Guide guideIn(GuideWay way, const Positions& rest)
{
  OnPlane plane = fittedPlane(rest).value_or(OnPlane{rest.colwise().mean(), Vector3::UnitZ(), 0});
  OnLine line = fittedLine(rest).value_or(OnLine{rest.colwise().mean(), Vector3::UnitZ()});
  if (way == PlaneThatFits) return FittedPlane{};
  if (way == LineThatFits) return FittedLine{};
  if (way == PlaneOfEach) plane.point.reset();
  if (way == LineOfEach) line.point.reset();
  return way == OnePlane || way == PlaneOfEach ? Guide(plane) : Guide(line);
}

class SlideSection : public GuideSection<SlideConstraint, &SlideConstraint::on> {
 public:
  explicit SlideSection(Editor& editor) : GuideSection(editor, tr("Slides"))
  {
    bindChoice(
        tr("Sta&y"), "slideGuide", tr("What the vertices stay on"),
        {tr("on a plane"), tr("each on a plane of its own"), tr("on a line"), tr("each on a line of its own"),
         tr("on the plane that fits them"), tr("on the line that fits them"), tr("on another mesh…")},
        [](const SlideConstraint& slide) { return static_cast<double>(wayOf(slide.on)); },
        [this](int way) { chooseWay(static_cast<GuideWay>(way)); });
    bindVector(
        tr("Th&rough"), "slideThrough",
        [](SlideConstraint slide) {
          const std::optional<Vector3>* through = throughOf(slide);
          return through == nullptr ? std::nullopt : *through;
        },
        tr("lead the plane or line of %1 through %2 = %3"),
        [](SlideConstraint& slide, int axis, double number) { (**throughOf(slide))[axis] = number; });
    bindGuides("slide");
    bindChoice(
        tr("Shifts"), "slideTogether", tr("Whether the plane or the line may shift"),
        {tr("no, it stays where it is"), tr("yes, as a whole")},
        [](const SlideConstraint& slide) -> std::optional<double> {
          if (std::holds_alternative<OnMesh>(slide.on)) return std::nullopt;
          return slide.together ? 1.0 : 0.0;
        },
        [this](int way) { chooseTogether(way == 1); });
  }

 private:
  void chooseWay(GuideWay way)
  {
    if (way == OneMesh) return askForMesh();
    edit(tr("slide %1 on another plane or line").arg(subject()), [&](SlideConstraint& slide) {
      const FoundVertices found = findVertices(editor(), slide.select);
      if (wayOf(slide.on) == way || found.vertices.empty()) return false;
      slide.on = guideIn(way, editor().model()->mesh.positions(found.vertices, Eigen::all));
      if (validateTolerance(slide.within, slide.directions())) slide.within = Exactly{};
      return true;
    });
  }

  void chooseTogether(bool together)
  {
    const QString name =
        together ? tr("let the plane or line of %1 shift") : tr("keep the plane or line of %1 where it is");
    edit(name.arg(subject()), [&](SlideConstraint& slide) {
      if (together) slide.within = Exactly{};
      return std::exchange(slide.together, together) != together;
    });
  }
};

}  // namespace

Sections newSlideSections(Editor& editor)
{
  return {new SlideSection(editor)};
}

}  // namespace holdfast
