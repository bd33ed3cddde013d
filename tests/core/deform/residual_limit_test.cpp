// With which residual a constraint is met: by its own numbers, whatever others ask for.

#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/rounding.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using test::kEpsilon;

constexpr double kFar = 1e9;  // diagonals

/// Two plates apart: vertices 0 to 24 and 25 to 49.
Mesh twoPlates()
{
  return test::merged(test::grid(4, 4), test::moved(test::grid(4, 4), {6, 0, 0}));
}

double diagonal()
{
  return boundingBoxDiagonal(twoPlates().positions);
}

/// `list`, and then a target out of all proportion for vertex 40.
ConstraintList withAbsurdTarget(ConstraintList list)
{
  list.constraints.push_back(test::moveTo(AtVertex{40}, Vector3(0, kFar * diagonal(), 0)));
  list.constraints.back().name = "absurd";
  return list;
}

TEST(ResidualLimit, OfAConstraintIsNotLoosenedByTheTargetOfAnother)
{
  const ConstraintList list = test::listOf({test::hold({0, 1}), test::moveBy(AtFace{9, {0.2, 0.3, 0.5}}, {0, 0, 1})});
  const DeformResult result = test::deformed(twoPlates(), withAbsurdTarget(list), {});
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_DOUBLE_EQ(*result.report.constraints[0].limit, 1e-12 * diagonal());
  EXPECT_DOUBLE_EQ(*result.report.constraints[1].limit, 1e-12 * diagonal());
  EXPECT_DOUBLE_EQ(*result.report.constraints[2].limit, 8 * kEpsilon * kFar * diagonal());
}

TEST(ResidualLimit, AConstraintThatIsMissedIsMissedBesideAnAbsurdTarget)
{
  const ConstraintList list = test::listOf({test::hold({0, 1}), test::moveBy(AtVertex{24}, {0, 0, 1})});
  const DeformOptions soft{Weights::Cotangent, {SolverKind::Soft, Backend::Holdfast, 1e4}};
  const Report alone = test::deformed(twoPlates(), list, soft).report;
  const Report beside = test::deformed(twoPlates(), withAbsurdTarget(list), soft).report;
  ASSERT_GT(*alone.constraints[1].residual, 1e-12 * diagonal());
  ASSERT_LT(*alone.constraints[1].residual, 8 * kEpsilon * kFar * diagonal());
  EXPECT_EQ(alone.constraints[1].status, ConstraintStatus::Missed);
  EXPECT_EQ(beside.constraints[1].status, ConstraintStatus::Missed);
}

TEST(ResidualLimit, OfAConstraintThatIsMissedIsTheSmallestOfTheRowsThatAre)
{
  // Vertex 24 is asked for near the origin, vertex 40 a billion diagonals away: soft constraints miss both.
  const double far = kFar * diagonal();
  const DeformOptions soft{Weights::Cotangent, {SolverKind::Soft, Backend::Holdfast, 1e4}};
  for (const std::vector<Index>& order : {std::vector<Index>{24, 40, 20}, std::vector<Index>{40, 24, 20}}) {
    std::vector<Vector3> targets;
    for (const Index vertex : order) targets.push_back(vertex == 40 ? Vector3(0, far, 0) : Vector3(4, 4, 1));
    const ConstraintList list = test::listOf(
        {test::hold({0, 1}), test::hold({25}), test::handle(order, VertexTargets{targets}, Vector3::Zero())});
    const Report report = test::deformed(twoPlates(), list, soft).report;
    ASSERT_EQ(report.constraints[2].status, ConstraintStatus::Missed);
    EXPECT_DOUBLE_EQ(*report.constraints[2].limit, 1e-12 * diagonal());
  }
}

TEST(ResidualLimit, OfAConstraintThatIsMetIsTheLargestOfItsRows)
{
  const double far = kFar * diagonal();
  const VertexTargets targets{{Vector3(4, 4, 1), Vector3(0, far, 0), Vector3(0, 4, 1)}};
  const ConstraintList list = test::listOf({test::hold({0, 1}), test::handle({24, 40, 20}, targets, Vector3::Zero())});
  const Report report = test::deformed(twoPlates(), list, {}).report;
  ASSERT_EQ(report.constraints[1].status, ConstraintStatus::Met);
  EXPECT_DOUBLE_EQ(*report.constraints[1].limit, 8 * kEpsilon * far);
}

TEST(ResidualLimit, OfTheRowThatIsMissedMostIsInTheMessage)
{
  // All are missed, those near the origin by less, and by more beside their limits.
  const double far = kFar * diagonal();
  const ConstraintList list =
      test::listOf({test::hold({0, 1}), test::moveTo(AtVertex{25}, Vector3(0, far + 1000 * diagonal(), 0)),
                    test::moveTo(AtVertex{40}, Vector3(0, far, 0)), test::moveBy(AtVertex{24}, {0, 0, 1})});
  const DeformOptions soft{Weights::Cotangent, {SolverKind::Soft, Backend::Holdfast, 1e4}};
  const Report report = test::deformed(twoPlates(), list, soft).report;
  const auto excess = [](const ConstraintOutcome& outcome) { return *outcome.residual / *outcome.limit; };
  const auto worst = std::ranges::max_element(report.constraints.all(), {}, excess);
  ASSERT_GT(*report.constraints[2].residual, *worst->residual);
  EXPECT_THAT(report.solve.message,
              testing::HasSubstr(fmt::format("\"{}\" is missed by {:.3g}, more than its limit {:.3g}", worst->name,
                                             *worst->residual, *worst->limit)));
}

TEST(ResidualLimit, AGapSlightlyBeyondItIsAConflictBesideAnAbsurdTarget)
{
  for (const double share : {0.4, 1.1}) {
    const ConstraintList list = test::listOf({test::hold({0, 1}), test::moveBy(AtVertex{24}, Vector3::Zero()),
                                              test::moveBy(AtVertex{24}, {0, 0, share * 1e-12 * diagonal()})});
    const ConstraintStatus expected = share < 0.5 ? ConstraintStatus::Redundant : ConstraintStatus::Conflicting;
    for (const ConstraintList& each : {list, withAbsurdTarget(list)}) {
      EXPECT_EQ(test::deformed(twoPlates(), each, {}).report.constraints[2].status, expected);
      const Report checked = diagnoseConstraints(makeModel(twoPlates(), "mesh"), each, "list");
      EXPECT_EQ(checked.constraints[2].status, expected);
      EXPECT_DOUBLE_EQ(*checked.constraints[2].limit, 1e-12 * diagonal());
    }
  }
}

TEST(ResidualLimit, OfARepetitionIsThatOfThePartnersWhoseRoundingItHas)
{
  // The place of vertex 25 follows from two large numbers that nearly cancel.
  const double far = kFar * diagonal();
  const ConstraintList list =
      test::listOf({test::moveTo(AtVertex{26}, {far, 0, 0}), test::moveTo(AtEdge{25, 26, 0.75}, {0.25 * far, 0, 0}),
                    test::moveTo(AtVertex{25}, {1e-9 * diagonal(), 0, 0})});
  const Report report = test::deformed(twoPlates(), list, {}).report;
  EXPECT_EQ(report.constraints[2].status, ConstraintStatus::Redundant) << *report.constraints[2].gap;
  EXPECT_DOUBLE_EQ(*report.constraints[2].limit, 8 * kEpsilon * far);
}

TEST(ResidualLimit, OfAKeptVectorGrowsWithThePlacesThatItIsTakenTo)
{
  const Vector3 far(kFar * diagonal(), 0, 0);
  const ConstraintList list =
      test::listOf({test::handle({0, 4, 20, 24}, std::monostate(), far),
                    {"", true, RelativeConstraint{AtFace{9, {0.2, 0.3, 0.5}}, AtFace{16, {0.3, 0.3, 0.4}}, {}}},
                    test::rigid({11, 12, 13})});
  const DeformResult result = test::deformed(twoPlates(), list, {});
  ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  for (const ConstraintOutcome& outcome : result.report.constraints) {
    ASSERT_TRUE(outcome.residual && outcome.limit);
    EXPECT_LE(*outcome.residual, *outcome.limit);
  }
  EXPECT_LE(*result.report.constraints[1].limit, 32 * kEpsilon * far.x());
}

TEST(ResidualLimit, OfARigidRegionAtRestFarFromTheOriginIsEightSpacingsOfTheCoordinates)
{
  const double far = 1e6 * diagonal();
  const Mesh away = test::moved(twoPlates(), {far, 0, 0});
  const DeformResult result = test::deformed(away, test::listOf({test::hold({0}), test::rigid({11, 12, 13})}), {});
  EXPECT_NEAR(*result.report.constraints[0].limit, 8 * kEpsilon * far, 1e-3 * 8 * kEpsilon * far);
  EXPECT_NEAR(*result.report.constraints[1].limit, 16 * kEpsilon * far, 1e-3 * 16 * kEpsilon * far);
}

}  // namespace
}  // namespace holdfast
