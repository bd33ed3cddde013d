#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/marks/point_preview.h>
#include <holdfast/widgets/scene/scene.h>

#include "render/compare_pictures.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

constexpr PictureSize kSize{480, 360};
constexpr Index kDivisions = 8;
constexpr double kBallSize = 10;  // pixels of the picture

/// A point under the cursor, drawn with a scene.
class ScenePreview {
 public:
  ScenePreview(const Scene& scene, const PreviewedPoint& point)
  {
    preview_.setBallPixels(kBallSize * scene.pixelRatio());
    preview_.set(point);
    for (vtkActor* const actor : preview_.actors()) scene.meshRenderer().AddActor(actor);
  }

 private:
  PointPreview preview_;
};

/// A slab held at one end and turned at the other, with a constraint of every kind and every fate on its top.
class Slab {
 public:
  Slab()
  {
    const auto face = [&](Index column, Index row) { return topFace(column, row); };
    const auto edge = [&](Index f) { return AtEdge{corner(f, 0), corner(f, 1), 0.5}; };
    const auto vertex = [&](Index f) { return AtVertex{corner(f, 0)}; };
    const auto inside = [&](Index f) { return AtFace{f, {0.25, 0.25, 0.5}}; };
    add(FixedConstraint{{VertexIds{end(0)}}});
    HandleConstraint rotated;
    rotated.select = {VertexIds{end(6)}};
    rotated.motion = AxisRotation{Vector3::UnitX(), 60, {}};
    rotated.translate = Vector3(0, 0, 1);
    add(rotated);
    add(RigidConstraint{{VertexIds{{corner(face(1, 2), 0), corner(face(1, 4), 0), corner(face(1, 6), 0)}}}});
    add(PointConstraint{inside(face(2, 5)), Move{{0, 0, 0.2}}});
    add(PointConstraint{edge(face(3, 2)), Move{{0, 0, 0.3}}});
    add(PointConstraint{vertex(face(4, 4)), Move{{0, 0, 0.5}}});
    add(PointConstraint{vertex(face(4, 4)), Move{{0, 0, 0.5}}});
    add(PointConstraint{inside(face(6, 4)), Move{{0, 0, 0.9}}});
    add(PointConstraint{inside(face(6, 4)), Move{{0, 0.3, 1.6}}});
    add(RelativeConstraint{vertex(face(2, 1)), vertex(face(5, 7)), {}});
    add(PointConstraint{vertex(face(5, 2)), Move{{0, 0, 0.9}}});
    list_.constraints.back().isEnabled = false;
    NoProgress progress;
    deformation_ = deform(model_, list_, "constraints", {}, progress);
  }

  [[nodiscard]] const DeformResult& deformation() const { return deformation_; }
  [[nodiscard]] const ConstraintList& list() const { return list_; }
  [[nodiscard]] const Model& model() const { return model_; }

  [[nodiscard]] std::vector<Index> middle() const
  {
    std::vector<Index> vertices;
    for (Index v = 0; v < model_.mesh.vertexCount(); ++v)
      if (std::abs(model_.mesh.positions(v, 0) - 4) < 1) vertices.push_back(v);
    return vertices;
  }

  /// Returns where the vertices inside the turned end are, none of them on a sharp edge.
  [[nodiscard]] std::vector<Vector3> insideTheTurnedEnd() const
  {
    std::vector<Vector3> places;
    for (const Index v : end(6)) {
      const Vector3 rest = model_.mesh.positions.row(v);
      if (rest.y() > 0 && rest.y() < 2 && rest.z() > 0 && rest.z() < 1)
        places.emplace_back(deformation_.positions.row(v));
    }
    return places;
  }

  /// Returns where a vertex of the top is.
  [[nodiscard]] Vector3 onTop(Index column, Index row) const
  {
    return deformation_.positions.row(corner(topFace(column, row), 0));
  }

 private:
  template <class What>
  void add(What what)
  {
    list_.constraints.push_back({"C" + std::to_string(list_.constraints.size()), true, std::move(what)});
  }

  [[nodiscard]] Index corner(Index face, int k) const { return model_.mesh.faces[face][k]; }

  /// A triangle of the top whose first corner is at this place of its grid.
  [[nodiscard]] Index topFace(Index column, Index row) const
  {
    const Vector3 place(6.0 * static_cast<double>(column) / kDivisions, 2.0 * static_cast<double>(row) / kDivisions, 1);
    for (Index f = 0; f < model_.mesh.faces.size(); ++f) {
      const bool isFlat = std::all_of(model_.mesh.faces[f].begin(), model_.mesh.faces[f].end(),
                                      [&](Index v) { return model_.mesh.positions(v, 2) == 1; });
      if (isFlat && model_.mesh.positions.row(corner(f, 0)).transpose().isApprox(place)) return f;
    }
    ADD_FAILURE() << "no face at " << place.transpose();
    return 0;
  }

  [[nodiscard]] std::vector<Index> end(double x) const
  {
    std::vector<Index> vertices;
    for (Index v = 0; v < model_.mesh.vertexCount(); ++v)
      if (model_.mesh.positions(v, 0) == x) vertices.push_back(v);
    return vertices;
  }

  Model model_ = makeModel(test::box({6, 2, 1}, kDivisions), "slab");
  ConstraintList list_;
  DeformResult deformation_;
};

/// With glyphs as large as in a window.
class SlabScene : public Scene {
 public:
  SlabScene(const Slab& slab, ColorBy colorBy)
      : Scene(slab.model(), slab.deformation(), {kSize, colorBy, Legend::Hidden, ""})
  {
    contents().setBallSize(kBallSize);
  }
};

Picture drawn(const Scene& scene)
{
  return draw(scene, "picture");
}

std::string differenceFromBaseline(const Scene& scene)
{
  return test::differenceFromBaseline(*scene.meshRenderer().GetActiveCamera(), [&] { return drawn(scene); });
}

void lookFromBelow(const Scene& scene)
{
  scene.meshRenderer().GetActiveCamera()->Elevation(-60);
  scene.meshRenderer().ResetCameraClippingRange();
}

std::ptrdiff_t accentedPixels(const Picture& picture)
{
  std::ptrdiff_t count = 0;
  for (std::size_t k = 0; k < picture.pixels.size(); k += 3)
    if (picture.pixels[k] > 110 && picture.pixels[k + 1] < 100 && picture.pixels[k + 2] > 200) ++count;
  return count;
}

TEST(SceneContents, GlyphsTellKindsAndStatusesApart)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  scene.contents().setMarks(constraintMarks(slab.model(), slab.list(), slab.deformation()));
  EXPECT_EQ(differenceFromBaseline(scene), "");
}

TEST(SceneContents, RegionsAreTintedEverywhere)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  const Picture with = drawn(scene);
  scene.contents().setMarks({});
  const Picture without = drawn(scene);
  const std::vector<Vector3> places = slab.insideTheTurnedEnd();
  EXPECT_EQ(places.size(), 49);
  for (const Vector3& place : places) {
    const Vector3 pixel = toDisplay(scene.meshRenderer(), place) / scene.pixelRatio();
    const auto at = 3 * (static_cast<std::size_t>(pixel.y()) * kSize.width + static_cast<std::size_t>(pixel.x()));
    EXPECT_LT(with.pixels[at], without.pixels[at] - 30) << "no dark tint at " << pixel.transpose();
  }
}

TEST(SceneContents, HighlightSelectionPreviewAndMeshEdges)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::Angle);
  SceneContents& contents = scene.contents();
  contents.highlight({0, 4, 7});
  contents.setSelection(slab.middle());
  const ScenePreview preview(scene, {slab.onTop(2, 3), MarkKind::Edge});
  contents.setMeshEdges(MeshEdges::All);
  EXPECT_EQ(differenceFromBaseline(scene), "");
}

TEST(SceneContents, ArrowsAndTheShapeAtRest)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::Angle);
  scene.contents().setRotationDisplay(RotationDisplay::Arrows);
  scene.contents().setRestGhost(RestGhost::Surface);
  EXPECT_EQ(differenceFromBaseline(scene), "");
}

TEST(SceneContents, PointsBehindTheSurfaceShowFaintly)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  scene.contents().setHiddenMarks(HiddenMarks::Faint);
  lookFromBelow(scene);
  EXPECT_EQ(differenceFromBaseline(scene), "");
}

TEST(SceneContents, TwoSidedColors)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  auto coloring = coloringOf(slab.model(), slab.deformation(), ColorBy::Angle, "");
  coloring->scale.map = ColorMap::BlueWhiteOrange;
  scene.contents().color(coloring);
  scene.contents().setMarks({});
  EXPECT_EQ(differenceFromBaseline(scene), "");
}

TEST(SceneContents, GoingBackLeavesNoTrace)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::Angle);
  const Picture before = drawn(scene);
  SceneContents& contents = scene.contents();
  contents.setPositions(1.1 * slab.model().mesh.positions);
  contents.color(std::nullopt);
  contents.setMarks({});
  contents.highlight({0, 4, 7});
  contents.setHiddenMarks(HiddenMarks::Faint);
  contents.setSelection(slab.middle());
  contents.setMeshEdges(MeshEdges::All);
  contents.setRestGhost(RestGhost::Hidden);
  contents.setRotationDisplay(RotationDisplay::Arrows);
  contents.setDetail(Detail::Coarse);
  EXPECT_GT(test::shareOfOtherPixels(before, drawn(scene)), 0.05);

  contents.show(slab.deformation());
  contents.color(coloringOf(slab.model(), slab.deformation(), ColorBy::Angle, ""));
  contents.highlight({});
  contents.setHiddenMarks(HiddenMarks::Invisible);
  contents.setSelection({});
  contents.setMeshEdges(MeshEdges::Sharp);
  contents.setRestGhost(RestGhost::Edges);
  contents.setRotationDisplay(RotationDisplay::Hidden);
  contents.setDetail(Detail::Full);
  EXPECT_EQ(drawn(scene).pixels, before.pixels);
}

TEST(SceneContents, GlyphsKeepTheirSizeWhateverTheCameraDoes)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  const ScenePreview preview(scene, {slab.onTop(4, 3), MarkKind::Vertex});
  vtkCamera& camera = *scene.meshRenderer().GetActiveCamera();
  const Vector3 place = slab.onTop(4, 3);
  camera.SetFocalPoint(place.x(), place.y(), place.z());
  const auto usual = accentedPixels(drawn(scene));
  EXPECT_GT(usual, 30);
  for (const double factor : {4.0, 1.0 / 16}) {
    camera.Zoom(factor);
    EXPECT_NEAR(static_cast<double>(accentedPixels(drawn(scene))) / static_cast<double>(usual), 1, 0.15) << factor;
  }
}

TEST(SceneContents, TiltedSurfacesDoNotCutTheRingAroundThePreview)
{
  const Model model = makeModel(test::grid(40, 40), "grid");
  NoProgress progress;
  const DeformResult deformation = deform(model, test::listOf({test::hold({0})}), "constraints", {}, progress);
  Scene scene(model, deformation, {kSize, ColorBy::None, Legend::Hidden, ""});
  const ScenePreview preview(scene, {{20, 20, 0}, MarkKind::Vertex});
  vtkCamera& camera = *scene.meshRenderer().GetActiveCamera();
  const auto seenAt = [&](double degrees) {
    const double tilt = degrees * std::numbers::pi / 180;
    camera.SetParallelScale(20);
    camera.SetFocalPoint(20, 20, 0);
    camera.SetPosition(20, 20 - 100 * std::sin(tilt), 100 * std::cos(tilt));
    camera.SetViewUp(0, 1, 0);
    scene.meshRenderer().ResetCameraClippingRange();
    return static_cast<double>(accentedPixels(drawn(scene)));
  };
  for (const bool isParallel : {false, true}) {
    camera.SetParallelProjection(isParallel);
    const double facing = seenAt(0);
    EXPECT_GT(facing, 100);
    EXPECT_NEAR(seenAt(65) / facing, 1, 0.1) << "parallel: " << isParallel;
  }
}

TEST(SceneContents, LargeMeshesLookMuchTheSameInCoarseDetail)
{
  const Model model = makeModel(test::icosphere(6), "sphere");
  NoProgress progress;
  const DeformResult deformation = deform(
      model, test::listOf({test::hold({0}), test::moveBy(AtVertex{40}, {0, 0, 0.5})}), "constraints", {}, progress);
  Scene scene(model, deformation, {kSize, ColorBy::Displacement, Legend::Hidden, ""});
  const Picture full = drawn(scene);
  scene.contents().setDetail(Detail::Coarse);
  const Picture coarse = drawn(scene);
  EXPECT_GT(test::shareOfOtherPixels(full, coarse), 0);
  EXPECT_LT(test::shareOfOtherPixels(full, coarse), 0.01);
}

TEST(SceneContents, BacksOfASolidAreLeftOutWhereTheyAreNotSeen)
{
  const Model model = makeModel(test::icosphere(6), "sphere");
  NoProgress progress;
  const DeformResult deformation = deform(model, test::listOf({test::hold({0})}), "constraints", {}, progress);
  Scene scene(model, deformation, {kSize, ColorBy::Displacement, Legend::Hidden, ""});
  SceneContents& contents = scene.contents();
  vtkProperty& look = *contents.mesh().surface().GetProperty();
  contents.setDetail(Detail::Coarse);
  const Picture whole = drawn(scene);
  EXPECT_FALSE(look.GetBackfaceCulling()) << "nobody has said where the eye is";
  contents.lookFrom({0, 0, 9});
  EXPECT_TRUE(look.GetBackfaceCulling());
  // Pixels of the outline, where the last back is seen beside the last front.
  constexpr double kOutline = 0.001;
  EXPECT_LT(test::shareOfOtherPixels(whole, drawn(scene)), kOutline);
  look.BackfaceCullingOff();
  look.FrontfaceCullingOn();
  EXPECT_GT(test::shareOfOtherPixels(whole, drawn(scene)), 10 * kOutline) << "the control: without the fronts";
  look.FrontfaceCullingOff();
  contents.lookFrom({0.1, 0.2, 0.3});
  EXPECT_FALSE(look.GetBackfaceCulling()) << "inside, backs are all that is seen";
  contents.lookFrom({0, 0, 9});
  contents.setDetail(Detail::Full);
  EXPECT_FALSE(look.GetBackfaceCulling()) << "what is turned inside out must be seen";
}

// What the baselines must not let pass.

TEST(SceneContentsMustFail, WhereAGlyphIsThatOfAnotherKind)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  const Picture right = drawn(scene);
  std::vector<ConstraintMark> marks = scene.contents().marks();
  for (ConstraintMark& mark : marks)
    if (mark.kind == MarkKind::Edge) mark.kind = MarkKind::Face;
  scene.contents().setMarks(marks);
  EXPECT_GT(test::shareOfOtherPixels(right, drawn(scene)), 2 * test::kLargestShareOfOtherPixels);
}

TEST(SceneContentsMustFail, WithoutFaintPoints)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  lookFromBelow(scene);
  const Picture without = drawn(scene);
  scene.contents().setHiddenMarks(HiddenMarks::Faint);
  EXPECT_GT(test::shareOfOtherPixels(without, drawn(scene)), 5 * test::kLargestShareOfOtherPixels);
}

TEST(SceneContentsMustFail, WhereArrowsPointTheOtherWay)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::Angle);
  scene.contents().setRotationDisplay(RotationDisplay::Arrows);
  const Picture right = drawn(scene);
  DeformResult turnedBack = slab.deformation();
  turnedBack.rotations *= -1;
  scene.contents().show(turnedBack);
  EXPECT_GT(test::shareOfOtherPixels(right, drawn(scene)), 50 * test::kLargestShareOfOtherPixels);
}

TEST(SceneContentsMustFail, WithoutTheShapeAtRest)
{
  const Slab slab;
  SlabScene scene(slab, ColorBy::None);
  scene.contents().setRestGhost(RestGhost::Surface);
  const Picture right = drawn(scene);
  scene.contents().setRestGhost(RestGhost::Hidden);
  EXPECT_GT(test::shareOfOtherPixels(right, drawn(scene)), 50 * test::kLargestShareOfOtherPixels);
}

}  // namespace
}  // namespace holdfast
