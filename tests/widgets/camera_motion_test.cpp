#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/camera_state.h>

namespace holdfast {
namespace {

/// A renderer with a window that is never shown; with a perspective or a parallel projection.
class CameraMotion : public ::testing::TestWithParam<bool> {
 protected:
  CameraMotion()
  {
    window->SetOffScreenRendering(1);
    window->SetSize(800, 600);
    window->AddRenderer(renderer);
    vtkCamera& camera = *renderer->GetActiveCamera();
    camera.SetParallelProjection(GetParam());
    camera.SetParallelScale(3);
    camera.SetPosition(4, -9, 5);
    camera.SetFocalPoint(0.3, 0.2, 0.1);
    camera.SetViewUp(0, 0, 1);
    camera.SetClippingRange(1, 40);
  }

  [[nodiscard]] DisplayPoint displayOf(const Vector3& place) { return toDisplay(*renderer, place).head<2>(); }

  [[nodiscard]] double distanceFromEye(const Vector3& place) const
  {
    return (place - Vector3(renderer->GetActiveCamera()->GetPosition())).norm();
  }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  const Vector3 anchor{0.9, -0.4, 0.7};
};

constexpr double kPixel = 1e-6;  // far less than one, far more than rounding

TEST_P(CameraMotion, OrbitKeepsTheDistanceToThePivot)
{
  const double before = distanceFromEye(anchor);
  orbit(*renderer->GetActiveCamera(), anchor, 33, -21);
  EXPECT_NEAR(distanceFromEye(anchor), before, 1e-12 * before);
}

TEST_P(CameraMotion, OrbitKeepsThePivotWhereItIsOnTheScreen)
{
  const DisplayPoint before = displayOf(anchor);
  orbit(*renderer->GetActiveCamera(), anchor, 33, -21);
  EXPECT_LT((displayOf(anchor) - before).norm(), kPixel);
}

TEST_P(CameraMotion, OrbitToTheRightMovesWhatIsInFrontToTheRight)
{
  const Vector3 toEye = (Vector3(renderer->GetActiveCamera()->GetPosition()) - anchor).normalized();
  const Vector3 inFront = anchor + 0.5 * toEye;
  const DisplayPoint before = displayOf(inFront);
  orbit(*renderer->GetActiveCamera(), anchor, 5, 0);
  EXPECT_GT(displayOf(inFront).x(), before.x() + 1);
  const DisplayPoint between = displayOf(inFront);
  orbit(*renderer->GetActiveCamera(), anchor, 0, 5);
  EXPECT_GT(displayOf(inFront).y(), between.y() + 1);
}

TEST_P(CameraMotion, OrbitGoesOnOverThePole)
{
  for (int step = 0; step < 360; ++step) orbit(*renderer->GetActiveCamera(), anchor, 0, 1);
  EXPECT_LT((Vector3(renderer->GetActiveCamera()->GetPosition()) - Vector3(4, -9, 5)).norm(), 1e-9);
}

TEST_P(CameraMotion, WhatIsGrabbedFollowsTheCursor)
{
  const DisplayPoint from = displayOf(anchor);
  const DisplayPoint to = from + DisplayPoint(120, -70);
  pan(*renderer, anchor, from, to);
  EXPECT_LT((displayOf(anchor) - to).norm(), kPixel);
}

TEST_P(CameraMotion, ZoomKeepsWhatIsUnderTheCursorThere)
{
  const DisplayPoint before = displayOf(anchor);
  const DisplayPoint besideBefore = displayOf(anchor + Vector3(0.1, 0, 0));
  zoom(*renderer, anchor, 1.5);
  EXPECT_LT((displayOf(anchor) - before).norm(), kPixel);
  const double growth = (displayOf(anchor + Vector3(0.1, 0, 0)) - before).norm() / (besideBefore - before).norm();
  EXPECT_NEAR(growth, 1.5, 0.02);
}

TEST_P(CameraMotion, ZoomOutUndoesZoomIn)
{
  const Vector3 eye(renderer->GetActiveCamera()->GetPosition());
  zoom(*renderer, anchor, 1.25);
  zoom(*renderer, anchor, 1 / 1.25);
  EXPECT_LT((Vector3(renderer->GetActiveCamera()->GetPosition()) - eye).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Projections, CameraMotion, ::testing::Bool(),
                         [](const auto& projection) { return projection.param ? "Parallel" : "Perspective"; });

}  // namespace
}  // namespace holdfast
