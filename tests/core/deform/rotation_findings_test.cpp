// What is doubtful about a rotation field is in the report, with and without a solution.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Vector3 kUp = Vector3::UnitZ();

Constraint rotatedInPlace(Index vertex, double degrees)
{
  return test::handle({vertex}, AxisRotation{kUp, degrees, {}}, Vector3::Zero());
}

/// The report of the solution and that of the diagnosis alone.
std::vector<Report> reportsOf(const Mesh& mesh, const ConstraintList& list, const DeformOptions& options = {})
{
  return {test::deformed(mesh, list, options).report,
          diagnoseConstraints(makeModel(mesh, "mesh"), list, "list", options)};
}

TEST(RotationFindings, NameTheConstraintsWhoseRotationsDisagreeInARigidRegion)
{
  const ConstraintList list =
      test::listOf({test::hold({0, 6}), test::rigid({6, 7, 8}), rotatedInPlace(24, 20), rotatedInPlace(8, 40)});
  for (const Report& report : reportsOf(test::grid(4, 4), list)) {
    EXPECT_NE(report.solve.status, SolveStatus::Conflicts);
    const Finding* const finding = test::findingOf(report, "rotations_disagree");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->idsOf, "constraint");
    EXPECT_THAT(finding->ids, ElementsAre(0, 3));
    EXPECT_THAT(finding->message, HasSubstr("differ by up to 40 degrees"));
    EXPECT_NEAR(*report.solve.disagreementDegrees, 40, 1e-12);
    EXPECT_LT(*report.solve.rotationAccuracy, 1e-9);
  }
}

TEST(RotationFindings, SayNothingWhereRotationsAgreeOrNoneIsAskedFor)
{
  const ConstraintList agreeing =
      test::listOf({test::hold({0}), test::rigid({6, 7, 8}), rotatedInPlace(6, 20), rotatedInPlace(8, 20)});
  for (const Report& report : reportsOf(test::grid(4, 4), agreeing)) {
    EXPECT_EQ(test::findingOf(report, "rotations_disagree"), nullptr);
    EXPECT_EQ(report.solve.disagreementDegrees, 0);
  }
  for (const Report& report : reportsOf(test::grid(4, 4), test::listOf({test::hold({0})}))) {
    EXPECT_FALSE(report.solve.disagreementDegrees);
    EXPECT_FALSE(report.solve.rotationAccuracy);
    EXPECT_EQ(test::findingOf(report, "floored_rotation_weights"), nullptr) << "no rotation field is made";
  }
}

TEST(RotationFindings, TellWhereWeightsWereFlooredAndCapped)
{
  // A square of no width has a needle, and obtuse angles beside it.
  Mesh mesh = test::grid(2, 2);
  mesh.positions.row(4) << 1, 1e-4, 0;
  const ConstraintList list = test::listOf({test::hold({0}), rotatedInPlace(8, 30)});
  for (const Report& report : reportsOf(mesh, list)) {
    const Finding* const floored = test::findingOf(report, "floored_rotation_weights");
    ASSERT_NE(floored, nullptr);
    EXPECT_GT(floored->count, 0);
    const Finding* const capped = test::findingOf(report, "capped_rotation_weights");
    ASSERT_NE(capped, nullptr);
    EXPECT_THAT(capped->ids, testing::IsSupersetOf({0, 1, 4}));
  }
  // The diagonals of a grid lie across two right angles.
  for (const Mesh& good : {test::icosphere(2), test::grid(2, 2)})
    for (const Report& report : reportsOf(good, test::listOf({test::hold({0}), rotatedInPlace(8, 30)}))) {
      EXPECT_EQ(test::findingOf(report, "floored_rotation_weights"), nullptr);
      EXPECT_EQ(test::findingOf(report, "capped_rotation_weights"), nullptr);
    }
}

TEST(RotationFindings, AFieldThatCannotBeFoundFailsTheDiagnosisToo)
{
  Mesh mesh = test::grid(4, 4);
  mesh.faces.add({0, 2, 1});
  const ConstraintList list = test::listOf({test::hold({20}), rotatedInPlace(24, 30)});
  const DeformOptions literal{Weights::CotangentPaper, {}};
  const Report report = diagnoseConstraints(makeModel(mesh, "mesh"), list, "list", literal);
  EXPECT_EQ(report.solve.status, SolveStatus::Failed);
  EXPECT_THAT(report.solve.message, HasSubstr("the rotation field cannot be solved: the weight of the edge"));
  EXPECT_EQ(report.solve.weights, Weights::CotangentPaper);
  EXPECT_EQ(diagnoseConstraints(makeModel(mesh, "mesh"), list, "list").solve.status, SolveStatus::NotRun);
}

}  // namespace
}  // namespace holdfast
