#include "holdfast/view/interaction/corner_axes.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>

#include <holdfast/view/camera_motion.h>

#include "interaction/interaction_stage.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

struct OrientationOfGrid : testing::Test, test::InteractionStage {
  OrientationOfGrid() : InteractionStage(test::grid(4, 3))
  {
    window().SetNumberOfLayers(2);
    widget->SetParentRenderer(&renderer());
    widget->AnimateOff();
    widget->On();
    lookFromCorner();
  }

  ~OrientationOfGrid() override { widget->SetInteractor(nullptr); }

  void lookFromCorner()
  {
    vtkCamera& camera = *renderer().GetActiveCamera();
    camera.SetFocalPoint(2, 1.5, 0);
    camera.SetPosition(7, 5, 9);
    camera.SetViewUp(0, 1, 0);
    renderer().ResetCamera();
    window().Render();
  }

  void clickBall(int axis, bool isPositive)
  {
    vtkNew<vtkPropCollection> parts;
    widget->GetOrientationRepresentation()->GetActors(parts);
    // The container, and for each axis the shafts and two balls.
    auto* ball = vtkActor::SafeDownCast(parts->GetItemAsObject(1 + 3 * axis + (isPositive ? 1 : 2)));
    hand().click(toDisplay(*widget->GetDefaultRenderer(), Vector3(ball->GetCenter())).head<2>());
    window().Render();
  }

  [[nodiscard]] Vector3 sight() const { return Vector3(renderer().GetActiveCamera()->GetDirectionOfProjection()); }

  vtkNew<OrientationWidget> widget;
};

TEST_F(OrientationOfGrid, ABallLooksFromItsEndAndTheOneThatFacesTheViewerFromBehind)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0}) {
      lookFromCorner();
      clickBall(axis, side > 0);
      EXPECT_LT((sight() + side * Vector3::Unit(axis)).norm(), 1e-6);
      lookFromCorner();
      clickBall(axis, side > 0);
      EXPECT_LT((sight() + side * Vector3::Unit(axis)).norm(), 1e-6) << "whatever was clicked before";
      clickBall(axis, side > 0);
      EXPECT_LT((sight() - side * Vector3::Unit(axis)).norm(), 1e-6);
    }
}

TEST_F(OrientationOfGrid, HasItsSizeInPixelsOfTheDisplay)
{
  const auto size = [&] {
    window().Render();
    return Eigen::Vector2i(widget->GetDefaultRenderer()->GetSize());
  };
  widget->SetPixelRatio(1);
  EXPECT_NEAR(size().x(), 120, 1);
  EXPECT_NEAR(size().y(), 120, 1);
  widget->SetPixelRatio(1.5);
  EXPECT_NEAR(size().x(), 180, 1);
  EXPECT_NEAR(size().y(), 180, 1);
}

}  // namespace
}  // namespace holdfast
