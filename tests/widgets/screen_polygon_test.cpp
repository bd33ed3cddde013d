
#include <gtest/gtest.h>

#include <holdfast/widgets/picking/screen_selection.h>

#include "support/random.h"

namespace holdfast {
namespace {

/// Tells whether a line straight up from `point` crosses the polygon an odd number of times; corners are not straight
/// above.
bool isPlainlyInside(const std::vector<DisplayPoint>& polygon, const DisplayPoint& point)
{
  int crossings = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const DisplayPoint& a = polygon[k];
    const DisplayPoint& b = polygon[(k + 1) % polygon.size()];
    if ((a.x() < point.x()) == (b.x() < point.x())) continue;
    const double share = (point.x() - a.x()) / (b.x() - a.x());
    if (a.y() + share * (b.y() - a.y()) > point.y()) ++crossings;
  }
  return crossings % 2 == 1;
}

TEST(ScreenPolygon, HoldsWhatAnOddNumberOfSidesIsAbove)
{
  test::Random random(41);
  int inside = 0;
  for (const int corners : {3, 4, 7, 50, 2000}) {
    std::vector<DisplayPoint> polygon;
    for (int k = 0; k < corners; ++k) polygon.emplace_back(random.uniform(0, 100), random.uniform(-50, 80));
    const ScreenPolygon area(polygon);
    for (int k = 0; k < 500; ++k) {
      const DisplayPoint point(random.uniform(-20, 120), random.uniform(-70, 100));
      ASSERT_EQ(area.contains(point), isPlainlyInside(polygon, point)) << corners << " corners, " << point.transpose();
      inside += area.contains(point) ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 300);
}

TEST(ScreenPolygon, CornersAtTheHeightOfAPointCountOnce)
{
  const std::vector<DisplayPoint> star{{0, 0}, {2, 4}, {4, 0}, {0, 2}, {4, 2}};
  const ScreenPolygon rhombus(std::vector<DisplayPoint>{{0, 2}, {2, 0}, {4, 2}, {2, 4}});
  EXPECT_TRUE(rhombus.contains({1, 2}));
  EXPECT_FALSE(rhombus.contains({-1, 2}));
  EXPECT_FALSE(rhombus.contains({-1, 0}));
  EXPECT_FALSE(rhombus.contains({-1, 4}));
  EXPECT_FALSE(ScreenPolygon(star).contains({2, 1.5})) << "the middle of a star is enclosed twice";
  EXPECT_TRUE(ScreenPolygon(star).contains({2, 3}));
}

TEST(ScreenPolygon, WithoutAnAreaHoldsNothing)
{
  EXPECT_FALSE(ScreenPolygon(std::vector<DisplayPoint>{}).contains({0, 0}));
  EXPECT_FALSE(ScreenPolygon(std::vector<DisplayPoint>{{1, 1}}).contains({1, 1}));
  EXPECT_FALSE(ScreenPolygon(std::vector<DisplayPoint>{{1, 1}, {3, 1}, {2, 1}}).contains({2, 1}));
}

}  // namespace
}  // namespace holdfast
