#include <algorithm>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/outcomes.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

enum class Noise { None, OfOne, OfAll };

Mesh bentPlate(const Mesh& plate)
{
  return test::transformed(plate, Eigen::Affine3d(Eigen::AngleAxisd(0.4, Vector3(3, 1, 2).normalized())));
}

/// Points at random in faces of a plate, at their places in a rotated copy but for `noise`.
ConstraintList crowdedPoints(const Mesh& plate, double pointsPerVertex, Noise noise, std::uint32_t seed)
{
  test::Random random(seed);
  const Mesh target = bentPlate(plate);
  const auto count = static_cast<Index>(pointsPerVertex * static_cast<double>(plate.vertexCount()));
  std::vector<Constraint> constraints;
  for (Index k = 0; k < count; ++k) {
    const Index face = random.integer(0, plate.faces.size() - 1);
    const double a = random.uniform(0.05, 0.9);
    const double b = random.uniform(0.02, 0.95 - a);
    const std::array<double, 3> weights{a, b, 1 - a - b};
    Vector3 place = Vector3::Zero();
    for (std::size_t c = 0; c < 3; ++c) place += weights[c] * target.positions.row(target.faces[face][c]).transpose();
    if (noise == Noise::OfAll || (noise == Noise::OfOne && k == count / 2)) place += test::randomVector(random, 1e-3);
    constraints.push_back(test::moveTo(AtFace{face, {a, b, 1 - a - b}}, place));
  }
  return test::listOf(std::move(constraints));
}

constexpr std::array kPointsPerVertex{0.8, 0.95, 1.1, 2.0, 3.0};

TEST(CrowdedPoints, ThatAgreeAreMetOrRepeatOthers)
{
  const Mesh plate = test::plate(30, 30);
  for (const double pointsPerVertex : kPointsPerVertex) {
    SCOPED_TRACE(pointsPerVertex);
    const Report report = test::deformed(plate, crowdedPoints(plate, pointsPerVertex, Noise::None, 1), {}).report;
    EXPECT_EQ(report.solve.status, SolveStatus::Ok) << report.solve.message;
    EXPECT_GT(countOf(report, ConstraintStatus::Redundant), 0);
    EXPECT_LE(report.solve.maxResidualRelative, 1e-12);
  }
}

TEST(CrowdedPoints, OfWhichOneIsOffHaveConflictsThatEnd)
{
  const Mesh plate = test::plate(30, 30);
  for (const double pointsPerVertex : {1.1, 2.0}) {
    SCOPED_TRACE(pointsPerVertex);
    const Report report = test::deformed(plate, crowdedPoints(plate, pointsPerVertex, Noise::OfOne, 1), {}).report;
    EXPECT_NE(report.solve.status, SolveStatus::Failed) << report.solve.message;
    EXPECT_LT(countOf(report, ConstraintStatus::Conflicting), plate.vertexCount() / 10) << "far from it all agree";
  }
}

TEST(CrowdedPoints, ThatAreAllOffAreLeftOutAndTheFindingSaysWhatHelps)
{
  const Mesh plate = test::plate(30, 30);
  for (const double pointsPerVertex : {1.1, 2.0}) {
    SCOPED_TRACE(pointsPerVertex);
    const Report report = test::deformed(plate, crowdedPoints(plate, pointsPerVertex, Noise::OfAll, 1), {}).report;
    EXPECT_EQ(report.solve.status, SolveStatus::Conflicts) << report.solve.message;
    const Finding* crowded = test::findingOf(report, "crowded_constraints");
    ASSERT_NE(crowded, nullptr);
    EXPECT_EQ(crowded->count, countOf(report, ConstraintStatus::Conflicting));
    EXPECT_THAT(crowded->message, HasSubstr("give fewer points, or let the solver \"soft\""));
  }
}

TEST(CrowdedPoints, AreNoFindingWhereAHundredConflictAtMost)
{
  const Mesh plate = test::plate(8, 8);
  const Report report = test::deformed(plate, crowdedPoints(plate, 1.1, Noise::OfAll, 2), {}).report;
  EXPECT_GT(countOf(report, ConstraintStatus::Conflicting), 0);
  EXPECT_EQ(test::findingOf(report, "crowded_constraints"), nullptr);
}

TEST(CrowdedPoints, NameAHundredPartnersOfTheFirstHundredAndTheNumberOfAll)
{
  const Mesh plate = test::plate(30, 30);
  const Report report = test::deformed(plate, crowdedPoints(plate, 2, Noise::OfAll, 3), {}).report;
  std::size_t before = 0;
  for (const ConstraintOutcome& outcome : report.constraints) {
    if (outcome.conflictSets.empty()) continue;
    const std::size_t most = before++ < kMostWithManyPartners ? kMostNamedPartners : kFewPartners;
    for (const ConflictSet& set : outcome.conflictSets) {
      EXPECT_EQ(set.with.size(), std::min(most, static_cast<std::size_t>(set.withCount)));
      EXPECT_EQ(set.with.size(), outcome.dependsOn.size());
    }
  }
  EXPECT_GT(before, kMostWithManyPartners);
}

TEST(CrowdedPoints, ThatCannotBeToldFromOthersAreNamed)
{
  const auto pair = [](double apart) {
    return test::listOf({test::hold({24}), test::moveBy(AtFace{0, {0.3, 0.3, 0.4}}, Vector3::UnitZ()),
                         test::moveBy(AtFace{0, {0.3 + apart, 0.3, 0.4 - apart}}, Vector3::UnitZ())});
  };
  const Report close = test::deformed(test::grid(4, 4), pair(1e-13), {}).report;
  const Finding* undecided = test::findingOf(close, "undecided_constraints");
  ASSERT_NE(undecided, nullptr);
  EXPECT_THAT(undecided->ids, testing::ElementsAre(2));
  for (const double apart : {0.0, 1e-9})
    EXPECT_EQ(test::findingOf(test::deformed(test::grid(4, 4), pair(apart), {}).report, "undecided_constraints"),
              nullptr);
}

}  // namespace
}  // namespace holdfast
