#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include "holdfast/widgets/camera/display_transform.h"
#include "widgets/plain_view.h"

namespace holdfast {
namespace {

using test::PlainScreen;
using test::PlainView;
using test::Projection;

class Projections : public testing::TestWithParam<Projection> {
 protected:
  static PlainView fromCorner()
  {
    PlainView view;
    view.eye = {3, 4, 9};
    view.projection = GetParam();
    return view;
  }

  PlainScreen screen{fromCorner()};
};

TEST_P(Projections, AreVtksButForDepths)
{
  vtkMatrix4x4& vtks = *screen.renderer().GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      screen.renderer().GetTiledAspectRatio(), -1, 1);
  const Eigen::Matrix4d ours = projectionOf(screen.renderer()) * viewOf(screen.renderer());
  for (const int row : {0, 1, 3})
    for (int column = 0; column < 4; ++column) EXPECT_NEAR(ours(row, column), vtks.GetElement(row, column), 1e-12);
}

/// What is drawn besides changes that range.
TEST_P(Projections, AreBitForBitTheSameForEveryClippingRange)
{
  vtkCamera& camera = *screen.renderer().GetActiveCamera();
  const DisplayPoint pixel(123.5, 45.5);
  camera.SetClippingRange(0.37, 1234.5);
  const DisplayTransform view(screen.renderer());
  const Ray ray = view.rayThrough(pixel);
  for (const double near : {0.1, 0.3, 1.7, 3.3, 7.9}) {
    camera.SetClippingRange(near, 17 * near);
    EXPECT_EQ(toDisplay(DisplayTransform(screen.renderer()), {1, 2, 3}), toDisplay(view, {1, 2, 3}));
    const Ray again = DisplayTransform(screen.renderer()).rayThrough(pixel);
    EXPECT_EQ(again.origin, ray.origin);
    EXPECT_EQ(again.direction, ray.direction);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Projections, testing::Values(Projection::Perspective, Projection::Parallel));

}  // namespace
}  // namespace holdfast
