// Solutions and rotation fields tell how accurate they are, warn, and are refused.

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
