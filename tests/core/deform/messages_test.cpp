// What is said of constraints that are missed: what is known, and no cause that is not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/messages.h>

namespace holdfast {
namespace {

using testing::HasSubstr;
using testing::Not;

Report reportOf(double sensitivity)
{
  std::vector<ConstraintOutcome> outcomes(2);
  outcomes[1].name = "P1";
  outcomes[1].status = ConstraintStatus::Missed;
  outcomes[1].sensitivity = sensitivity;
  Report report;
  report.constraints = outcomes;
  report.solve.accuracy = 3e-14;
  return report;
}

TEST(MissedMessage, NamesTheConstraintItsResidualAndItsLimit)
{
  for (const double sensitivity : {1.0, 1e8})
    EXPECT_THAT(missedMessage(reportOf(sensitivity), {1, 2e-9, 5e-12}),
                HasSubstr("\"P1\" is missed by 2e-09, more than its limit 5e-12"));
}

TEST(MissedMessage, BlamesConstraintsThatNearlyRepeatItWhereItsAmplificationShowsThem)
{
  EXPECT_THAT(missedMessage(reportOf(1e8), {1, 2e-9, 5e-12}), HasSubstr("nearly repeat it"));
  EXPECT_THAT(missedMessage(reportOf(1e8), {1, 2e-9, 5e-12}), HasSubstr("amplification 1e+08"));
}

TEST(MissedMessage, ElseSaysThatTheCauseIsNotKnownAndWhatIs)
{
  const std::string message = missedMessage(reportOf(3), {1, 2e-9, 5e-12});
  EXPECT_THAT(message, Not(HasSubstr("repeat")));
  EXPECT_THAT(message, HasSubstr("the cause is not known (amplification of the constraint 3, accuracy 3e-14 of the "));
  EXPECT_THAT(message, HasSubstr("it may help to leave it out"));
}

TEST(SolvedMessage, ShowsTheAccuracy)
{
  EXPECT_EQ(solvedMessage(reportOf(1), {}), "all constraints are met; accuracy 3e-14");
}

TEST(SolvedMessage, NamesTheConstraintThatIsMissedMost)
{
  Report report = reportOf(1);
  report.solve.options.kind = SolverKind::Lagrange;
  EXPECT_THAT(solvedMessage(report, MissedRow{1, 2e-9, 5e-12}),
              HasSubstr("1 of 2 constraints are met only approximately (\"P1\" is missed by 2e-09, more than its "
                        "limit 5e-12); the solver \"hard\" meets them exactly"));
}

}  // namespace
}  // namespace holdfast
