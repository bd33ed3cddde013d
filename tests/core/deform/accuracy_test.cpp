// Solutions and rotation fields tell how accurate they are, warn, and are refused.

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/messages.h>
#include <holdfast/deform/rotation_factorization.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

TEST(Accuracy, IsGoodThenDoubtfulThenRefused)
{
  EXPECT_FALSE(accuracyWarning("low_accuracy", "the solution", 1e-9));
  const std::optional<Finding> warning = accuracyWarning("low_accuracy", "the solution", 2e-9);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, "low_accuracy");
  EXPECT_EQ(warning->idsOf, "solution");
  EXPECT_THAT(warning->message, HasSubstr("the solution is accurate to 2e-09 only"));
  EXPECT_EQ(accuracyFailure(1e-6), "");
  EXPECT_FALSE(accuracyWarning("low_accuracy", "the solution", 2e-6)) << "a failure says more";
  EXPECT_THAT(accuracyFailure(2e-6), HasSubstr("accurate to 2e-06 only, and 1e-06 is needed"));
}

/// A strip of `length` squares that is held at one end and moved at the other: what lies between is the harder to find,
/// the longer it is.
DeformResult deformedStrip(Index length)
{
  const Mesh strip = test::grid(length, 1);
  return test::deformed(
      strip,
      test::listOf({test::hold({0, length + 1}), test::moveBy(AtVertex{length}, {0, 0, static_cast<double>(length)})}),
      {});
}

TEST(Accuracy, OfALongStripIsWarnedOfWhereItIsDoubtful)
{
  int doubtful = 0;
  // Longer strips than the first doubtful one go to sparse QR, which takes Eigen minutes.
  for (double length = 500; doubtful == 0 && length < 25000; length *= 1.5) {
    const Report report = deformedStrip(static_cast<Index>(length)).report;
    if (report.solve.status == SolveStatus::Failed) continue;
    const bool isDoubtful = report.solve.accuracy > 1e-9;
    doubtful += isDoubtful ? 1 : 0;
    EXPECT_EQ(test::findingOf(report, "low_accuracy") != nullptr, isDoubtful) << length;
  }
  EXPECT_GT(doubtful, 0) << "the test has met no doubtful solution";
}

/// A list whose rows nearly depend on one another, the more the smaller `apart` is, and that a shift of the whole
/// meets.
struct NearlyDependentCase {
  const char* name;
  ConstraintList (*list)(double apart);
};

const Vector3 kShiftOfAll(0.3, 0.1, 0.7);

ConstraintList pairInAFace(double apart)
{
  return test::listOf({test::moveBy(AtVertex{24}, kShiftOfAll), test::moveBy(AtFace{0, {0.25, 0.5, 0.25}}, kShiftOfAll),
                       test::moveBy(AtFace{0, {0.25 + apart, 0.5 - apart, 0.25}}, kShiftOfAll)});
}

ConstraintList pointBesideACorner(double apart)
{
  return test::listOf({test::moveBy(AtVertex{0}, kShiftOfAll), test::moveBy(AtEdge{0, 1, 1 - apart}, kShiftOfAll)});
}

ConstraintList fourInAFace(double apart)
{
  ConstraintList list = test::listOf({test::moveBy(AtVertex{24}, kShiftOfAll)});
  for (const auto& [a, b] : {std::pair(0.0, 0.0), std::pair(apart, 0.0), std::pair(0.0, apart)})
    list.constraints.push_back(test::moveBy(AtFace{7, {0.25 + a, 0.25 + b, 0.5 - a - b}}, kShiftOfAll));
  return test::listOf(list.constraints);
}

ConstraintList pairOfTwoKinds(double apart)
{
  return test::listOf({test::handle({18, 19, 23, 24}, {}, kShiftOfAll), test::moveBy(AtEdge{6, 7, 0.5}, kShiftOfAll),
                       test::moveBy(AtFace{10, {0.5 - apart, 0.5 + apart, 0}}, kShiftOfAll)});
}

class NearlyDependentRows : public testing::TestWithParam<NearlyDependentCase> {};

TEST_P(NearlyDependentRows, AreWarnedOfAndRefusedByWhatTheyLose)
{
  const Mesh plate = test::grid(4, 4);
  for (double apart = 1e-2; apart > 3e-12; apart /= 3) {
    SCOPED_TRACE(apart);
    const Report report = test::deformed(plate, GetParam().list(apart), {}).report;
    const bool isRefused = report.solve.accuracy > 1e-6;
    EXPECT_EQ(report.solve.status, isRefused ? SolveStatus::Failed : SolveStatus::Ok) << report.solve.message;
    EXPECT_EQ(test::findingOf(report, "low_accuracy") != nullptr, report.solve.accuracy > 1e-9 && !isRefused);
    double largest = 0;
    for (const ConstraintOutcome& outcome : report.constraints)
      largest = std::max(largest, outcome.sensitivity.value_or(0));
    EXPECT_LT(report.solve.accuracy, 2e-15 * largest + 1e-12);
  }
}

TEST_P(NearlyDependentRows, LoseNoMoreThanTheAccuracyTells)
{
  const Mesh plate =
      test::transformed(test::grid(4, 4), Eigen::Affine3d(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized())));
  for (double apart = 1e-2; apart > 1e-9; apart /= 3) {
    SCOPED_TRACE(apart);
    const DeformResult result = test::deformed(plate, GetParam().list(apart), {});
    if (result.report.solve.status == SolveStatus::Failed) continue;
    const Positions error = result.positions - test::moved(plate, kShiftOfAll).positions;
    // Positions are rounded themselves.
    EXPECT_LE(error.cwiseAbs().maxCoeff(), result.report.solve.accuracy * kShiftOfAll.cwiseAbs().maxCoeff() + 4e-15);
  }
}

TEST_P(NearlyDependentRows, AreNamedWithWhatHelpsWhereTheSolutionIsDoubtfulOrRefused)
{
  const Mesh plate = test::grid(4, 4);
  const Report doubtful = test::deformed(plate, GetParam().list(1e-8), {}).report;
  ASSERT_NE(test::findingOf(doubtful, "low_accuracy"), nullptr) << doubtful.solve.message;
  EXPECT_THAT(test::findingOf(doubtful, "low_accuracy")->message, HasSubstr("nearly follows from other constraints"));
  const Report refused = test::deformed(plate, GetParam().list(4e-12), {}).report;
  EXPECT_EQ(refused.solve.status, SolveStatus::Failed);
  EXPECT_THAT(refused.solve.message, HasSubstr("1e-06 is needed: \"P"));
  EXPECT_THAT(refused.solve.message, HasSubstr("leave one of them out, or move their points apart"));
}

INSTANTIATE_TEST_SUITE_P(Cases, NearlyDependentRows,
                         testing::Values(NearlyDependentCase{"PairInAFace", pairInAFace},
                                         NearlyDependentCase{"PointBesideACorner", pointBesideACorner},
                                         NearlyDependentCase{"FourInAFace", fourInAFace},
                                         NearlyDependentCase{"PairOfTwoKinds", pairOfTwoKinds}),
                         [](const auto& what) { return what.param.name; });

TEST(Accuracy, OfNearlyDependentRowsThatStayAtRestIsFull)
{
  ConstraintList list = pairInAFace(1e-11);
  for (Constraint& constraint : list.constraints) std::get<PointConstraint>(constraint.what).to = Move{Vector3::Zero()};
  list.constraints.push_back(test::moveBy(AtVertex{24 + 3}, kShiftOfAll));
  const Mesh plates = test::merged(test::grid(4, 4), test::moved(test::grid(4, 4), {6, 0, 0}));
  const Report report = test::deformed(plates, list, {}).report;
  EXPECT_EQ(report.solve.status, SolveStatus::Ok) << report.solve.message;
  EXPECT_LT(report.solve.accuracy, 1e-13);
}

/// A plate whose two inner vertices, 5 and 6, lie `apart`: the closer, the stronger the edge between them, and the less
/// the others have to say about the rotation of both.
SolverMesh platePinched(double apart)
{
  Mesh mesh = test::grid(3, 2);
  mesh.positions.row(5) << 2 - apart, 1, 0;
  return test::solverMeshOf(mesh);
}

/// With all other rotations given.
Rotations rotationsOf(const SolverMesh& mesh)
{
  ConstraintSystem system;
  for (Index u = 0; u < mesh.unknownCount(); ++u)
    if (u != 5 && u != 6) system.rotations.push_back({u, {0, 0, 0.1 * static_cast<double>(u)}, 0});
  NoProgress progress;
  return RotationFactorization(mesh, std::make_shared<const Operators>(makeOperators(mesh, Weights::CotangentPaper)),
                               Backend::Holdfast)
      .solve(system, progress);
}

TEST(Accuracy, OfARotationFieldThatIsHardlyDeterminedIsWarnedOfOrRefused)
{
  int refused = 0;
  int doubtful = 0;
  for (double apart = 0.5; apart > 1e-15; apart /= 2) {
    const Rotations rotations = rotationsOf(platePinched(apart));
    refused += rotations.failure.empty() ? 0 : 1;
    if (!rotations.accuracy) continue;
    EXPECT_EQ(rotations.failure.empty(), *rotations.accuracy <= 1e-6) << rotations.failure;
    const bool isDoubtful = *rotations.accuracy > 1e-9 && *rotations.accuracy <= 1e-6;
    doubtful += isDoubtful ? 1 : 0;
    Report report;
    takeOver(rotations, report);
    EXPECT_EQ(test::findingOf(report, "low_rotation_accuracy") != nullptr, isDoubtful) << apart;
    EXPECT_EQ(report.solve.rotationAccuracy, rotations.accuracy);
  }
  EXPECT_GT(refused, 0) << "the test has met no useless field";
  EXPECT_GT(doubtful, 0) << "the test has met no doubtful field";
}

}  // namespace
}  // namespace holdfast
