#include <numeric>

#include <gtest/gtest.h>

#include <holdfast/widgets/marks/evenly_spread.h>

#include "support/meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

double nearestPair(const Positions& points, const std::vector<Index>& places)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      nearest = std::min(nearest, (points.row(places[i]) - points.row(places[j])).norm());
  return nearest;
}

double farthestFromAll(const Positions& points, const std::vector<Index>& places)
{
  double farthest = 0;
  for (Index k = 0; k < points.rows(); ++k) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Index place : places) nearest = std::min(nearest, (points.row(place) - points.row(k)).norm());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(EvenlySpread, IsAboutAsManyAsAskedFor)
{
  const Positions sphere = test::icosphere(4).positions;
  for (const Index target : {100, 400, 1500}) {
    const auto count = static_cast<double>(evenlySpread(sphere, target).size());
    EXPECT_NEAR(count / static_cast<double>(target), 1, 0.25) << target;
  }
}

TEST(EvenlySpread, KeepsADistanceAndLeavesNoHoles)
{
  for (const double size : {1.0, 1e-200, 1e150}) {
    const Positions points = test::icosphere(4).positions * size;
    const std::vector<Index> places = evenlySpread(points, 200);
    EXPECT_GE(nearestPair(points, places), farthestFromAll(points, places) * (1 - 1e-12)) << size;
  }
}

TEST(EvenlySpread, IsAllOfFew)
{
  const Positions points = test::box({1, 2, 3}, 2).positions;
  std::vector<Index> all(static_cast<std::size_t>(points.rows()));
  std::iota(all.begin(), all.end(), Index{0});
  EXPECT_EQ(evenlySpread(points, points.rows()), all);
  EXPECT_TRUE(evenlySpread(Positions(0, 3), 5).empty());
}

TEST(EvenlySpread, OfSomePointsKnowsNoOthers)
{
  const Positions sphere = test::icosphere(4).positions;
  std::vector<Index> upper;
  for (Index k = sphere.rows() - 1; k >= 0; --k)
    if (sphere(k, 2) > 0) upper.push_back(k);
  const std::vector<Index> chosen = evenlySpread(sphere, upper, 100);
  const Positions alone = sphere(upper, Eigen::all);
  std::vector<Index> expected;
  for (const Index k : evenlySpread(alone, 100)) expected.push_back(upper[k]);
  EXPECT_EQ(chosen, expected);
  EXPECT_EQ(evenlySpread(sphere, {7, 3}, 2), (std::vector<Index>{7, 3}));
}

TEST(EvenlySpread, OfPointsInOnePlaceIsOne)
{
  EXPECT_EQ(evenlySpread(Positions::Constant(50, 3, 7.5), 10), std::vector<Index>{0});
}

TEST(EvenlySpread, TakesRandomCloudsFarFromTheOrigin)
{
  test::Random random(3);
  Positions points(5000, 3);
  for (Index k = 0; k < points.rows(); ++k)
    points.row(k) << random.uniform(-1, 1), 1e6 + random.uniform(0, 1), -1e6 + random.uniform(0, 0.01);
  const std::vector<Index> places = evenlySpread(points, 100);
  EXPECT_GE(nearestPair(points, places), farthestFromAll(points, places) * (1 - 1e-9));
  EXPECT_EQ(places, evenlySpread(points, 100));
}

}  // namespace
}  // namespace holdfast
