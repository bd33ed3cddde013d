#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/window/viewport/label_place.h>

#include "support/random.h"

namespace holdfast {
namespace {

const QRectF kRoom(0, 0, 400, 300);

TEST(LabelPlace, WhatHasRoomStaysWhereItIs)
{
  const QRectF box(20, 30, 80, 20);
  EXPECT_EQ(movedInto(box, kRoom), box);
  EXPECT_EQ(movedClear(box, kRoom, {}), box);
  EXPECT_EQ(movedClear(box, kRoom, {{20, 60, 80, 20}}), box);
}

TEST(LabelPlace, WhatReachesPastAnEdgeTouchesIt)
{
  EXPECT_EQ(movedInto({-5, 290, 80, 20}, kRoom), QRectF(0, 280, 80, 20));
  EXPECT_EQ(movedInto({390, -7, 80, 20}, kRoom), QRectF(320, 0, 80, 20));
  EXPECT_EQ(movedInto({50, 50, 900, 20}, kRoom), QRectF(0, 50, 900, 20)) << "the beginning is read";
}

TEST(LabelPlace, ManyStayInsideAndApartWhileThereIsRoom)
{
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    test::Random random(seed);
    std::vector<QRectF> placed;
    for (int k = 0; k < 6; ++k) {
      const double x = random.uniform(-50, 450);
      const double y = random.uniform(-50, 350);
      const QRectF place = movedClear({x, y, 90, 22}, kRoom, placed);
      EXPECT_TRUE(kRoom.contains(place));
      for (const QRectF& other : placed) EXPECT_FALSE(place.intersects(other));
      placed.push_back(place);
    }
  }
}

TEST(LabelPlace, IsTheNearestThatIsFree)
{
  const QRectF other(20, 100, 80, 20);
  EXPECT_EQ(movedClear({30, 95, 80, 20}, kRoom, {other}).top(), 78);
  EXPECT_EQ(movedClear({30, 105, 80, 20}, kRoom, {other}).top(), 122);
  // Where nothing is free it stays.
  EXPECT_EQ(movedClear({30, 95, 80, 20}, kRoom, {kRoom}), QRectF(30, 95, 80, 20));
}

}  // namespace
}  // namespace holdfast
