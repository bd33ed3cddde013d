#include <gtest/gtest.h>

#include <holdfast/constraints/axis_systems.h>

namespace holdfast {
namespace {

ConstraintRow pin(Index unknown, const Vector3& shift, const RowDirections& directions = {})
{
  ConstraintRow row{{{unknown, 1.0}}, shift, shift, unknown};
  row.directions = directions;
  return row;
}

ConstraintSystem systemOf(std::vector<ConstraintRow> rows)
{
  ConstraintSystem system;
  system.rows = std::move(rows);
  return system;
}

std::optional<Eigen::Matrix3d> frameOf(const std::vector<RowDirections>& directions)
{
  std::vector<ConstraintRow> rows;
  for (const RowDirections& some : directions) rows.push_back(pin(0, Vector3::Ones(), some));
  return commonFrame(rows);
}

TEST(RowDirections, HoldTheirPartOfAVector)
{
  const Vector3 v(1, 2, 3);
  EXPECT_EQ(RowDirections().held(v), v);
  EXPECT_EQ(RowDirections::along({0, 0, -5}).held(v), Vector3(0, 0, 3));
  EXPECT_EQ(RowDirections::across({0, 0, 1e-200}).held(v), Vector3(1, 2, 0));
}

TEST(CommonFrame, IsThatOfTheCoordinatesWhereTheyDo)
{
  EXPECT_EQ(frameOf({{}, {}}), Eigen::Matrix3d::Identity());
  EXPECT_EQ(frameOf({RowDirections::along({0, -2, 0}), {}, RowDirections::across({7, 0, 0})}),
            Eigen::Matrix3d::Identity());
}

TEST(CommonFrame, HasTheAxesOfRowsThatAreParallelOrSquare)
{
  const Vector3 a(1, 2, 3);
  const Vector3 b = a.cross(Vector3(3, -1, 2));
  for (const auto& directions :
       {std::vector{RowDirections::along(a)}, std::vector{RowDirections::along(a), RowDirections::across(-4 * b)},
        std::vector{RowDirections::across(b), RowDirections::along(a.cross(b)), RowDirections::along(-a)}}) {
    const std::optional<Eigen::Matrix3d> frame = frameOf(directions);
    ASSERT_TRUE(frame);
    EXPECT_LT((frame->transpose() * *frame - Eigen::Matrix3d::Identity()).norm(), 1e-15);
    for (const RowDirections& some : directions)
      EXPECT_NEAR((frame->transpose() * some.axis()).cwiseAbs().maxCoeff(), 1, 1e-15);
  }
}

TEST(CommonFrame, IsNoneWhereDirectionsAreAtOdds)
{
  EXPECT_EQ(frameOf({RowDirections::along({1, 0, 0}), RowDirections::along({1, 1e-9, 0})}), std::nullopt);
  EXPECT_EQ(frameOf({RowDirections::along({1, 2, 3}), RowDirections::across({0, 0, 1})}), std::nullopt);
}

TEST(AxisSystems, AreOneWhereAllRowsHoldInAllDirections)
{
  const ConstraintSystem system = systemOf({pin(3, {0.1, 0.2, 0.3}), pin(5, {1, 2, 3})});
  const std::vector<AxisSystem> systems = axisSystems(system, Eigen::Matrix3d::Identity());
  ASSERT_EQ(systems.size(), 1U);
  EXPECT_TRUE(systems[0].axes.all());
  EXPECT_EQ(systems[0].rows, (std::vector<Index>{0, 1}));
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(systems[0].system.rows[r].target, system.rows[r].target);
    EXPECT_EQ(systems[0].system.rows[r].shift, system.rows[r].shift);
  }
}

TEST(AxisSystems, ShareAxesAlongWhichTheSameRowsHold)
{
  const std::vector<AxisSystem> systems = axisSystems(
      systemOf({pin(0, {1, 2, 3}), pin(1, {4, 5, 6}, RowDirections::along({0, 1, 0}))}), Eigen::Matrix3d::Identity());
  ASSERT_EQ(systems.size(), 2U);
  EXPECT_EQ(systems[0].axes, 0b101U);
  EXPECT_EQ(systems[0].rows, std::vector<Index>{0});
  EXPECT_EQ(systems[0].system.rows[0].shift, Vector3(1, 0, 3));
  EXPECT_EQ(systems[1].axes, 0b010U);
  EXPECT_EQ(systems[1].rows, (std::vector<Index>{0, 1}));
  EXPECT_EQ(systems[1].system.rows[0].shift, Vector3(0, 2, 0));
  EXPECT_EQ(systems[1].system.rows[1].shift, Vector3(0, 5, 0));
}

TEST(AxisSystems, AreThreeWhereNoTwoAxesHaveTheSameRows)
{
  const Eigen::Matrix3d frame = *frameOf({RowDirections::along({1, 2, 2}), RowDirections::across({2, 1, -2})});
  const std::vector<AxisSystem> systems =
      axisSystems(systemOf({pin(0, {1, 2, 3}), pin(1, {4, 5, 6}, RowDirections::along({1, 2, 2})),
                            pin(2, {7, 8, 9}, RowDirections::across({2, 1, -2}))}),
                  frame);
  ASSERT_EQ(systems.size(), 3U);
  EXPECT_EQ(systems[0].rows, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(systems[1].rows, std::vector<Index>{0});
  EXPECT_EQ(systems[2].rows, (std::vector<Index>{0, 2}));
  EXPECT_NEAR(systems[0].system.rows[1].shift[0], Vector3(1, 2, 2).normalized().dot(Vector3(4, 5, 6)), 1e-14);
}

TEST(AxisSystems, AreJoinedToWhatWasTakenApart)
{
  Columns3 u(2, 3);
  u << 0.1, -0.0, 0.3, 1e-30, 5, 6;
  for (const Eigen::Matrix3d& frame :
       {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), *frameOf({RowDirections::along({1, 2, 2})})}) {
    const Columns3 joined = joinedAxes({alongAxes(u, 0b101, frame), alongAxes(u, 0b010, frame)}, frame);
    if (frame.isIdentity(0))
      EXPECT_EQ(joined, u);
    else
      EXPECT_LT((joined - u).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace holdfast
