#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <holdfast/geometry/rotation_log.h>

#include "holdfast/widgets/camera/display_transform.h"
#include "widgets/plain_view.h"

namespace holdfast {
namespace {

using test::PlainScreen;
using test::PlainView;
using test::Projection;

constexpr double kDegreesRounding = 1e-9;

class DegreesSeen : public testing::TestWithParam<Projection> {
 protected:
  static PlainView viewFrom()
  {
    PlainView view;
    view.eye = {0, 0, 10};
    view.projection = GetParam();
    return view;
  }

  PlainScreen screen{viewFrom()};
  const DisplayTransform view{screen.renderer()};
};

TEST_P(DegreesSeen, InAPlaneAcrossTheViewAreTheAngleAboutItsAxis)
{
  const Vector3 center(0.3, -0.2, 0);
  for (const double degrees : {0.0, 10.0, 90.0, 179.0, -45.0}) {
    const Vector3 to = center + Vector3(std::cos(degrees * kDegree), std::sin(degrees * kDegree), 0);
    EXPECT_NEAR(degreesSeen(view, center, center + Vector3::UnitX(), to, 0), degrees, kDegreesRounding);
  }
}

TEST_P(DegreesSeen, GoOnOverWholeTurns)
{
  double seen = 0;
  for (int step = 1; step <= 108; ++step) {
    const double angle = 10 * step * kDegree;
    seen = degreesSeen(view, {0, 0, 0}, {1, 0, 0}, {std::cos(angle), std::sin(angle), 0}, seen);
    EXPECT_NEAR(seen, 10 * step, kDegreesRounding);
  }
}

TEST_P(DegreesSeen, DoNotSayWhatHappensAlongTheSight)
{
  // Straight towards the eye: nothing turns on the screen.
  const Vector3 from(1, 0, 0);
  const Vector3 eye(0, 0, 10);
  const Vector3 towards = GetParam() == Projection::Parallel ? Vector3(1, 0, 3) : Vector3(from + 0.3 * (eye - from));
  EXPECT_NEAR(degreesSeen(view, {0, 0, 0}, from, towards, 0), 0, kDegreesRounding);
}

TEST_P(DegreesSeen, StayAsTheyWereWhereNothingIsSeen)
{
  EXPECT_EQ(degreesSeen(view, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, 370), 370);
  EXPECT_EQ(degreesSeen(view, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, 370), 370);
  if (GetParam() == Projection::Perspective) {
    EXPECT_EQ(degreesSeen(view, {0, 0, 0}, {1, 0, 0}, {1, 0, 20}, 370), 370);
  }
}

INSTANTIATE_TEST_SUITE_P(Projections, DegreesSeen, testing::Values(Projection::Perspective, Projection::Parallel));

}  // namespace
}  // namespace holdfast
