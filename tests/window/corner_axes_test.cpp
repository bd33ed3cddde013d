// The axes in the corner of the picture.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCameraOrientationRepresentation.h>
#include <vtkNew.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerWidget.h>
#include <holdfast/window/tools/tools.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The bracket, seen from a corner.
class OrientationInCorner : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj");
    lookFromCorner();
  }

  void lookFromCorner()
  {
    viewport().lookAlong({-0.5, 0.7, -0.4}, Vector3::UnitZ());
    ASSERT_TRUE(settle());
  }

  /// The renderer that draws the axes, and what it draws.
  [[nodiscard]] std::pair<vtkRenderer*, vtkCameraOrientationRepresentation*> drawn()
  {
    vtkRendererCollection& renderers = *viewport().renderWindow()->GetRenderers();
    for (int k = 0; k < renderers.GetNumberOfItems(); ++k) {
      auto* renderer = static_cast<vtkRenderer*>(renderers.GetItemAsObject(k));
      vtkPropCollection& props = *renderer->GetViewProps();
      for (int prop = 0; prop < props.GetNumberOfItems(); ++prop)
        if (auto* axes = vtkCameraOrientationRepresentation::SafeDownCast(props.GetItemAsObject(prop)))
          return {renderer, axes};
    }
    throw std::runtime_error("nothing draws the axes");
  }

  /// The middle of the ball at the end of an axis.
  [[nodiscard]] QPointF ballAt(int axis, bool isPositive)
  {
    const auto [renderer, axes] = drawn();
    vtkNew<vtkPropCollection> parts;
    axes->GetActors(parts);
    // The container, and for each axis the shafts and two balls.
    auto* ball = vtkActor::SafeDownCast(parts->GetItemAsObject(1 + 3 * axis + (isPositive ? 1 : 2)));
    return viewport().toPlace(toDisplay(*renderer, Vector3(ball->GetCenter())).head<2>());
  }

  [[nodiscard]] vtkCamera& camera() { return *viewport().renderer().GetActiveCamera(); }
  [[nodiscard]] Vector3 sight() { return Vector3(camera().GetDirectionOfProjection()); }

  void clickBall(int axis, bool isPositive)
  {
    test::click(viewport(), ballAt(axis, isPositive));
    ASSERT_TRUE(settle());
  }
};

TEST_F(OrientationInCorner, IsInTheUpperRightOne)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const bool isPositive : {true, false}) {
      const QPointF ball = ballAt(axis, isPositive);
      EXPECT_GT(ball.x(), viewport().width() - 140);
      EXPECT_LT(ball.x(), viewport().width() - 10);
      EXPECT_GT(ball.y(), 10);
      EXPECT_LT(ball.y(), 140);
    }
}

TEST_F(OrientationInCorner, AClickOnABallLooksFromThere)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const bool isPositive : {true, false}) {
      lookFromCorner();
      clickBall(axis, isPositive);
      const Vector3 from = (isPositive ? 1 : -1) * Vector3::Unit(axis);
      EXPECT_LT((sight() + from).norm(), 1e-6) << "axis " << axis << (isPositive ? "" : ", from behind");
      EXPECT_NEAR(Vector3(camera().GetViewUp()).dot(from), 0, 1e-6);
      // Everything is in the picture, and large.
      const Positions& positions = editor().positions();
      const QRectF room = viewport().rect();
      double widest = 0;
      for (Index v = 0; v < positions.rows(); ++v) {
        const QPointF place = shownAt(positions.row(v).transpose());
        EXPECT_TRUE(room.contains(place));
        const QPointF off = place - room.center();
        widest = std::max({widest, std::abs(off.x()) / room.width(), std::abs(off.y()) / room.height()});
      }
      EXPECT_GT(widest, 0.25);
    }
}

TEST_F(OrientationInCorner, AClickLeavesWhatIsUpUpright)
{
  viewport().setUpAxis(UpAxis::Y);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool isPositive : {true, false}) {
      lookFromCorner();
      clickBall(axis, isPositive);
      const Vector3 up = axis != 1 ? Vector3::UnitY() : Vector3((isPositive ? -1 : 1) * Vector3::UnitZ());
      EXPECT_LT((Vector3(camera().GetViewUp()) - up).norm(), 1e-6) << "axis " << axis;
    }
}

TEST_F(OrientationInCorner, AClickOnTheBallThatFacesTheViewerLooksFromBehind)
{
  clickBall(0, true);
  clickBall(0, true);
  EXPECT_LT((sight() - Vector3::UnitX()).norm(), 1e-6);
  // Not where one has looked elsewhere in between.
  for (int k = 0; k < 3; ++k) {
    lookFromCorner();
    clickBall(2, true);
    EXPECT_LT((sight() + Vector3::UnitZ()).norm(), 1e-6) << k;
  }
  trigger("viewFront");
  ASSERT_TRUE(settle());
  clickBall(2, true);
  EXPECT_LT((sight() + Vector3::UnitZ()).norm(), 1e-6);
}

TEST_F(OrientationInCorner, ADragTurnsThePictureAboutItsMiddle)
{
  const Vector3 before = sight();
  const Vector3 middle(camera().GetFocalPoint());
  const double distance = camera().GetDistance();
  const QPointF from = ballAt(0, true);
  test::drag(viewport(), {from, from + QPointF(-10, 4), from + QPointF(-25, 8), from + QPointF(-40, 8)});
  ASSERT_TRUE(settle());
  EXPECT_GT((sight() - before).norm(), 0.1);
  EXPECT_LT((Vector3(camera().GetFocalPoint()) - middle).norm(), 1e-9 * distance);
  EXPECT_NEAR(camera().GetDistance(), distance, 1e-9 * distance);
}

TEST_F(OrientationInCorner, NoToolGetsWhatItTakes)
{
  viewport().setParallelProjection(true);
  const auto state = editor().history().state();
  for (const char* tool : {"toolPoint", "toolBrush", "toolRectangle", "toolFlood", "toolRuler"}) {
    // So near that the surface lies under the axes.
    lookFromCorner();
    camera().Zoom(12);
    viewport().setCamera(cameraOf(camera()));
    ASSERT_TRUE(settle());
    const QPointF ball = ballAt(2, true);
    ASSERT_TRUE(SurfacePicker(viewport().surface())
                    .pick(viewport().renderer(), ball.x(), viewport().height() - ball.y(), PickKind::Face, 0));
    trigger(tool);
    test::click(viewport(), ball);
    ASSERT_TRUE(settle());
    EXPECT_LT((sight() + Vector3::UnitZ()).norm(), 1e-6) << tool;
    EXPECT_EQ(editor().history().state(), state) << tool;
    EXPECT_TRUE(editor().selectedVertices().empty()) << tool;
  }
  const auto& ruler = *static_cast<ToolOf<vtkHoldfastSurfaceRulerWidget>*>(window.findChild<Tool*>("rulerTool"));
  EXPECT_FALSE(ruler.widget().GetLocation(0));
}

}  // namespace
}  // namespace holdfast
