// Job 2: a scanned shape, a brush, a rectangle, and a handle that turns by more than a whole turn.

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

using RegionsJob = test::JobWindow;

TEST_F(RegionsJob, APaintedRegionStaysAndAHandleTurnsBy400Degrees)
{
  openFile(sample("head.ply"));
  key(Qt::Key_1, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  const QPointF neck = seenAt(nearestVertex({0, -12.6, -99}));
  key(Qt::Key_B);
  for (int k = 0; k < 4; ++k) key(Qt::Key_BracketRight);
  const Index fixed = constrainBy(Qt::Key_B, {neck, neck + QPointF(-40, -4), neck + QPointF(40, -4)}, Qt::Key_F);
  ASSERT_GT(verticesOf(fixed).size(), 50u);

  const double top = editor().positions().col(2).maxCoeff();
  const QPointF crown = seenAt(Vector3(0, 0, top));
  const Index handle = constrainBy(Qt::Key_M, {crown + QPointF(-200, -30), crown + QPointF(200, 60)}, Qt::Key_H);
  ASSERT_GT(verticesOf(handle).size(), 50u);
  ASSERT_EQ(editor().selectedConstraints(), std::vector<Index>{handle}) << "its rings stand";

  const Camera camera = cameraOf(*viewport().renderer().GetActiveCamera());
  const Vector3 sight = (camera.focalPoint - camera.position).normalized();
  test::moveMouse(viewport(), seenAt(window.gizmo().gizmo().GetFrame().center) + QPointF(kGizmoPixels, 0));
  ASSERT_EQ(window.gizmo().gizmo().GetPart(), GizmoPart::ViewRing);
  keys("400");
  key(Qt::Key_Return);
  ASSERT_TRUE(settle());

  const auto& turn = std::get<AxisRotation>(std::get<HandleConstraint>(list().constraints[handle].what).motion);
  EXPECT_NEAR(std::abs(turn.degrees), 400, 1e-9) << "not 40";
  EXPECT_NEAR(std::abs(turn.axis.normalized().dot(sight)), 1, 1e-9);
  for (const Index v : verticesOf(handle)) {
    const Index unknown = editor().model()->solverMesh.weld.unknownOf[v];
    ASSERT_NEAR(editor().deformation()->rotations.row(unknown).norm(), 200 * kRadians, 1e-9) << "half the angle";
  }
  // All of it moves as one rigid part by 40 degrees.
  const Vector3 axis = turn.axis.normalized() * (turn.degrees > 0 ? 1 : -1);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(40 * kRadians, axis).toRotationMatrix();
  const Index first = verticesOf(handle).front();
  for (const Index v : verticesOf(handle))
    ASSERT_LT((nowOf(v) - nowOf(first) - rotation * (restOf(v) - restOf(first))).norm(), 1e-9) << v;
  for (const Index v : verticesOf(fixed)) ASSERT_EQ(nowOf(v), restOf(v)) << v;
  expectAllMet();
  expectPicture();
}

}  // namespace
}  // namespace holdfast
