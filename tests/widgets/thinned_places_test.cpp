#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/widgets/rotation_sphere/rotation_projection.h>

#include "support/point_constraints.h"
#include "support/random.h"

namespace holdfast {
namespace {

using ::testing::ElementsAre;

std::vector<Vector3> onSphere(std::size_t count)
{
  test::Random random(5);
  std::vector<Vector3> places;
  while (places.size() < count)
    if (const Vector3 place = test::randomVector(random, 1); place.norm() > 0.1) places.push_back(place.normalized());
  return places;
}

/// How far the place that is worst off is from the nearest of those chosen.
double widestGap(const std::vector<Vector3>& places, const std::vector<Index>& chosen)
{
  double widest = 0;
  for (std::size_t k = 0; k < places.size(); k += 50) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Index other : chosen) nearest = std::min(nearest, (places[k] - places[other]).norm());
    widest = std::max(widest, nearest);
  }
  return widest;
}

TEST(ThinnedPlaces, AreAllWhereThereAreFew)
{
  const std::vector<Vector3> places(4, Vector3::UnitX());
  EXPECT_THAT(thinnedPlaces(places, 4, 0.001), ElementsAre(0, 1, 2, 3)) << "though they are the same";
  EXPECT_THAT(thinnedPlaces({}, 4, 0.001), ElementsAre());
}

TEST(ThinnedPlaces, LeaveOneOfThoseTogetherAndAllThatAreAlone)
{
  std::vector<Vector3> places(100, Vector3(0.3, 0.4, 0.5));
  places[40] = {-0.3, 0.4, 0.5};
  places[99] = {0.3, 0.4, 0.6};
  EXPECT_THAT(thinnedPlaces(places, 50, 0.001), ElementsAre(0, 40, 99));
}

TEST(ThinnedPlaces, AreSpreadEvenly)
{
  const std::vector<Vector3> places = onSphere(20'000);
  const std::vector<Index> chosen = thinnedPlaces(places, 2000, 0.001);
  EXPECT_LE(chosen.size(), 2000u);
  EXPECT_GT(chosen.size(), 400u);
  EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
  EXPECT_EQ(std::set<Index>(chosen.begin(), chosen.end()).size(), chosen.size());
  // 2,000 places on a sphere are 0.08 from one another.
  EXPECT_LT(widestGap(places, chosen), 0.3);
  // The judge sees a hole.
  std::vector<Index> half;
  std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(half), [&](Index k) { return places[k].x() < 0; });
  EXPECT_GT(widestGap(places, half), 0.9);
}

TEST(ThinnedPlaces, AreNoFewerThanTheFinestGridHolds)
{
  std::vector<Vector3> places;
  for (int k = 0; k < 30; ++k) places.emplace_back(0.1 * k + 0.05, 0.05, 0.05);
  EXPECT_EQ(thinnedPlaces(places, 29, 0.1).size(), 15u) << "of 30 cells first 30, then 15 are taken";
  EXPECT_EQ(thinnedPlaces(places, 30, 10).size(), 30u);
}

}  // namespace
}  // namespace holdfast
