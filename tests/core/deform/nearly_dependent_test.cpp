#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

/// One corner held, and four points of one face, `apart` of its edges from one another, all moved alike; the last is
/// `error` off that.
ConstraintList fourPoints(double apart, double error)
{
  const Vector3 shift(0, 0, 0.1);
  return test::listOf(
      {test::hold({24}), test::moveBy(AtFace{0, {0.3, 0.3, 0.4}}, shift),
       test::moveBy(AtFace{0, {0.3 + apart, 0.3, 0.4 - apart}}, shift),
       test::moveBy(AtFace{0, {0.3, 0.3 + apart, 0.4 - apart}}, shift),
       test::moveBy(AtFace{0, {0.3 + apart, 0.3 + apart, 0.4 - 2 * apart}}, shift + Vector3(0, 0, error))});
}

bool isWarnedOf(const Report& report)
{
  return test::findingOf(report, "nearly_dependent_constraints") != nullptr;
}

TEST(NearlyDependent, ConstraintsAmplifyByTheInverseOfTheirDistance)
{
  for (const double apart : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    SCOPED_TRACE(apart);
    const DeformResult result = test::deformed(test::grid(4, 4), fourPoints(apart, 0), {});
    for (std::size_t c = 1; c < 5; ++c) {
      ASSERT_TRUE(result.report.constraints[c].sensitivity);
      EXPECT_GT(*result.report.constraints[c].sensitivity * apart, 0.3);
      EXPECT_LT(*result.report.constraints[c].sensitivity * apart, 3);
    }
    EXPECT_EQ(result.report.constraints[0].sensitivity, 1);
    EXPECT_EQ(isWarnedOf(result.report), apart < 1e-6);
    // What doubles lose by so much is refused.
    EXPECT_EQ(result.report.solve.status, result.report.solve.accuracy > 1e-6 ? SolveStatus::Failed : SolveStatus::Ok)
        << result.report.solve.message;
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
  }
}

TEST(NearlyDependent, ConstraintsAreWarnedOfFromAMillionOn)
{
  int warnings = 0;
  for (double apart = 1e-7; apart < 1e-5; apart *= 1.1) {
    const Report report = test::deformed(test::grid(4, 4), fourPoints(apart, 0), {}).report;
    double largest = 0;
    for (const ConstraintOutcome& outcome : report.constraints)
      largest = std::max(largest, outcome.sensitivity.value_or(0));
    EXPECT_EQ(isWarnedOf(report), largest > 1e6) << largest;
    warnings += isWarnedOf(report) ? 1 : 0;
  }
  EXPECT_GT(warnings, 0);
}

TEST(NearlyDependent, AnInconsistencyMovesVerticesByWhatTheReportSays)
{
  // Without the third point the fourth is independent, and what it asks for is met, at a price.
  for (const double apart : {1e-3, 1e-5}) {
    ConstraintList rest = fourPoints(apart, 0);
    ConstraintList wrong = fourPoints(apart, 1e-6);
    rest.constraints.erase(rest.constraints.begin() + 3);
    wrong.constraints.erase(wrong.constraints.begin() + 3);
    const DeformResult before = test::deformed(test::grid(4, 4), rest, {});
    const DeformResult after = test::deformed(test::grid(4, 4), wrong, {});
    const double moved = (after.positions - before.positions).rowwise().norm().maxCoeff();
    const double told = 1e-6 * *after.report.constraints.back().sensitivity;
    EXPECT_LT(moved, 20 * told);
    EXPECT_GT(moved, 0.5 * told);
  }
}

TEST(NearlyDependent, PointsCloserThanDoublesTellApartAreRepetitions)
{
  for (const double apart : {1e-13, 1e-15}) {
    const DeformResult agreeing = test::deformed(test::grid(4, 4), fourPoints(apart, 0), {});
    EXPECT_EQ(agreeing.report.constraints[2].status, ConstraintStatus::Redundant);
    EXPECT_EQ(agreeing.report.constraints[4].status, ConstraintStatus::Redundant);
    EXPECT_FALSE(isWarnedOf(agreeing.report));
    const DeformResult arguing = test::deformed(test::grid(4, 4), fourPoints(apart, 1e-6), {});
    EXPECT_EQ(arguing.report.constraints[4].status, ConstraintStatus::Conflicting);
    EXPECT_EQ(arguing.report.constraints[4].dependsOn, std::vector<std::string>{"P1"});
    EXPECT_NEAR(*arguing.report.constraints[4].gap, 1e-6, 1e-12);
  }
}

TEST(NearlyDependent, SoftSolutionsOfConflictsCallThemselvesACompromise)
{
  const ConstraintList list =
      test::listOf({test::hold({24}), test::moveBy(AtVertex{0}, {0, 0, 0}), test::moveBy(AtVertex{0}, {0, 0, 0.2})});
  const DeformOptions soft{Weights::Cotangent, {SolverKind::Soft, Backend::Holdfast, 100}};
  const DeformResult result = test::deformed(test::grid(4, 4), list, soft);
  EXPECT_NEAR(result.positions(0, 2), 0.1, 0.02) << "halfway, as in Fig. 11";
  EXPECT_NE(result.report.solve.message.find("compromise"), std::string::npos) << result.report.solve.message;
  EXPECT_EQ(test::deformed(test::grid(4, 4), list, {}).positions(0, 2), 0) << "the earlier one stands";
}

}  // namespace
}  // namespace holdfast
