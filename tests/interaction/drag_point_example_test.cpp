// The program examples/drag_point.cpp and the recording beside it. What the recording points at is worked out here.

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h>
#include <holdfast/widgets/scene/scene_contents.h>

#include "interaction/gizmo_fixture.h"
#include "interaction/recorded_gesture.h"
#include "support/child_process.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::ProcessResult;
using testing::HasSubstr;

const std::string kMesh = test::dataFolder() + "/bracket.obj";
const std::string kRecording = test::sourceFolder() + "/examples/drag_point.recording";

constexpr Index kAxis = 1;  // of the arrow that is dragged

struct RecordedEvent {
  std::string name;
  DisplayPoint pixel = DisplayPoint::Zero();
};

RecordedEvent eventOf(const std::string& line)
{
  RecordedEvent event;
  std::istringstream(line) >> event.name >> event.pixel.x() >> event.pixel.y();
  return event;
}

/// The scene of the example before anything is held.
struct ExampleScene : test::InteractionFixture {
  ExampleScene() : InteractionFixture(readMesh(kMesh).mesh, 800, 600), contents(model())
  {
    renderer().RemoveAllViewProps();
    contents.addTo(renderer());
    renderer().SetBackground(1, 1, 1);
    renderer().ResetCamera();
    interactor().SetInteractorStyle(style);
    placer->SetSurface(surface());
    // Its first key is "f".
    placer->SetKind(PickKind::Face);
  }

  SceneContents contents;
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  vtkNew<vtkHoldfastSurfacePointPlacer> placer;
};

/// How far the shape is from that at rest after the affine map that fits best, model units.
double bend(const Positions& rest, const Positions& positions)
{
  Eigen::MatrixX4d space(rest.rows(), 4);
  space << rest, Eigen::VectorXd::Ones(rest.rows());
  const Eigen::Matrix4d gram = space.transpose() * space;
  const Eigen::Matrix<double, 4, 3> affine = gram.ldlt().solve(space.transpose() * positions);
  return (positions - space * affine).rowwise().norm().maxCoeff();
}

class DragPointExample : public testing::Test {
 protected:
  DragPointExample()
  {
    std::istringstream recording(test::bytesOf(kRecording));
    for (std::string line; std::getline(recording, line);) lines.push_back(line + '\n');
    std::string camera;
    for (const std::string& line : lines) {
      const RecordedEvent event = eventOf(line);
      if (event.name == "LeftButtonPressEvent") pressed.push_back(event.pixel);
      if (event.name == "LeftButtonReleaseEvent") released.push_back(event.pixel);
      if (pressed.empty()) camera += line;
    }
    test::replay(camera, scene.interactor());
  }

  [[nodiscard]] static ProcessResult run(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), HOLDFAST_DRAG_POINT);
    return test::runProcess(arguments);
  }
  [[nodiscard]] std::string result() const { return (folder.path() / "result.obj").string(); }
  void play(const std::string& recording)
  {
    const ProcessResult done = run({kMesh, result(), recording});
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.err, "");
    positions = readMesh(result()).mesh.positions;
  }
  [[nodiscard]] SurfacePick pickAt(const DisplayPoint& pixel) const
  {
    SurfacePick pick;
    EXPECT_TRUE(scene.placer->Pick(scene.renderer(), pixel.data(), pick));
    return pick;
  }
  [[nodiscard]] Vector3 movedPlaceOf(const SurfacePick& pick) const
  {
    return positionOf(pointOf(pick.location, model.mesh), positions);
  }

  /// How far along the arrow through `place` the middle of a pixel is, by halving.
  [[nodiscard]] double alongArrow(const Vector3& place, const DisplayPoint& pixel) const
  {
    const DisplayTransform display(scene.renderer());
    const auto shown = [&](double length) { return display.show(place + length * Vector3::Unit(kAxis)).point; };
    double least = -model.solverMesh.diagonal / 2;
    double most = model.solverMesh.diagonal / 2;
    const DisplayPoint along = shown(most) - shown(least);
    while (most - least > 1e-9) {
      const double middle = (least + most) / 2;
      const bool isBeyond = (centerOfPixel(pixel.x(), pixel.y()) - shown(middle)).dot(along) > 0;
      (isBeyond ? least : most) = middle;
    }
    return least;
  }

  ExampleScene scene;
  const Model& model = scene.model();
  std::vector<std::string> lines;
  std::vector<DisplayPoint> pressed;  // clicks, the last one on the point that is dragged; then the arrow
  std::vector<DisplayPoint> released;
  test::TemporaryFolder folder;
  Positions positions;
};

TEST_F(DragPointExample, HoldsWhatWasClickedAndTakesTheLastPointAlongTheArrow)
{
  play(kRecording);
  const double exact = 1e-12 * model.solverMesh.diagonal;
  ASSERT_GE(pressed.size(), 4U);
  for (std::size_t k = 0; k + 2 < pressed.size(); ++k) {
    const SurfacePick pick = pickAt(pressed[k]);
    EXPECT_TRUE(std::holds_alternative<AtFace>(pick.location));
    EXPECT_LE((movedPlaceOf(pick) - pick.place).norm(), exact);
  }
  const SurfacePick dragged = pickAt(pressed[pressed.size() - 2]);
  EXPECT_TRUE(std::holds_alternative<AtFace>(dragged.location));
  Vector3 moved = movedPlaceOf(dragged) - dragged.place;
  const double expected = alongArrow(dragged.place, released.back()) - alongArrow(dragged.place, pressed.back());
  const double pixel = std::abs(alongArrow(dragged.place, released.back() + DisplayPoint(0, 1)) -
                                alongArrow(dragged.place, released.back()));
  EXPECT_NEAR(moved[kAxis], expected, pixel) << "the recording keeps to the arrow's line but for whole pixels";
  EXPECT_GT(std::abs(moved[kAxis]), 10);
  moved[kAxis] = 0;
  EXPECT_LE(moved.norm(), exact);
  EXPECT_GT(bend(model.mesh.positions, positions), 1) << "not moved as a whole";
}

TEST_F(DragPointExample, MovesNothingWithoutTheDrag)
{
  std::string clicks;
  for (const std::string& line : lines) {
    clicks += line;
    const RecordedEvent event = eventOf(line);
    if (event.name == "LeftButtonReleaseEvent" && event.pixel == pressed[pressed.size() - 2]) break;
  }
  play(folder.file("clicks.recording", clicks).string());
  EXPECT_EQ(positions, model.mesh.positions);
  EXPECT_LE(bend(model.mesh.positions, positions), 1e-12 * model.solverMesh.diagonal);
}

TEST_F(DragPointExample, NamesWhatIsMissing)
{
  const ProcessResult alone = run({});
  EXPECT_EQ(alone.exitCode, 1);
  EXPECT_THAT(alone.err, HasSubstr("drag_point MESH.obj RESULT.obj [RECORDING]"));
  const ProcessResult noMesh = run({"nowhere.obj", result()});
  EXPECT_EQ(noMesh.exitCode, 1);
  EXPECT_THAT(noMesh.err, HasSubstr("nowhere.obj"));
  const ProcessResult noRecording = run({kMesh, result(), "nowhere.recording"});
  EXPECT_EQ(noRecording.exitCode, 1);
  EXPECT_THAT(noRecording.err, HasSubstr("nowhere.recording"));
  EXPECT_FALSE(std::filesystem::exists(result()));
}

/// What docs/images/drag_point.png shows.
TEST_F(DragPointExample, IsPicturedAtWork)
{
  play(kRecording);
  scene.contents.setPositions(positions);
  vtkNew<vtkHoldfastGizmoWidget> gizmo;
  vtkHoldfastGizmoRepresentation& arrows = *gizmo->GetGizmoRepresentation();
  arrows.SetMotions(GizmoMotions::Moves);
  arrows.SetFrame(movedPlaceOf(pickAt(pressed[pressed.size() - 2])), Eigen::Matrix3d::Identity());
  scene.enable(*gizmo);
  const DisplayPoint arrow = test::placeOnArrow(arrows, kAxis);
  const std::vector<int> plain = scene.colorAt(arrow);
  gizmo->SetPart(static_cast<GizmoPart>(static_cast<int>(GizmoPart::ArrowX) + kAxis));
  EXPECT_NE(scene.colorAt(arrow), plain) << "highlighted";
  scene.save(HOLDFAST_EXAMPLE_PICTURE);
}

}  // namespace
}  // namespace holdfast
