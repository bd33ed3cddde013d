#include <limits>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deform.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>

#include "support/law_meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using testing::ElementsAre;

std::vector<CsvRecord> tableOf(const Report& report)
{
  return splitCsv(reportToCsv(report), "report.csv");
}

std::optional<double> numberIn(const std::string& field)
{
  if (field.empty()) return std::nullopt;
  return parseNumber<double>(field).value;
}

TEST(ReportCsv, IsAHeaderAloneWithoutConstraints)
{
  EXPECT_EQ(reportToCsv({}),
            "name,type,rows,status,residual,limit,gap,depends_on,clash_count,amplification,force,distance,off_target,"
            "at_bound\n");
}

TEST(ReportCsv, QuotesNamesAndLeavesOutWhatWasNotComputed)
{
  Report report;
  ConstraintOutcome outcome{
      "bolt \"A\", left\nrim", "point", 1, ConstraintStatus::Conflicting, 0.1, 0.01, {}, {}, {}, {}, {}, {}};
  outcome.dependsOn = {"base", "P1, lower"};
  outcome.gap = 1.0 / 3;
  outcome.conflictSets.resize(2);
  outcome.sensitivity = std::numeric_limits<double>::infinity();
  outcome.multiplier = 0.0;
  outcome.nearDistance = 0.25;
  outcome.offTarget = 0.125;
  outcome.isAtBound = true;
  const ConstraintOutcome disabled{" blank", "fixed", 0, ConstraintStatus::Disabled, {}, {}, {}, {}, {}, {}, {}, {}};
  report.constraints = std::vector{outcome, disabled};
  const std::vector<CsvRecord> table = tableOf(report);
  ASSERT_EQ(table.size(), 3U);
  EXPECT_THAT(table[1].fields,
              ElementsAre("bolt \"A\", left\nrim", "point", "1", "conflicting", "0.1", "0.01", "0.3333333333333333",
                          "base; P1, lower", "2", "", "0", "0.25", "0.125", "true"));
  EXPECT_THAT(table[2].fields,
              ElementsAre(" blank", "fixed", "0", "disabled", "", "", "", "", "0", "", "", "", "", ""));
}

TEST(ReportCsv, SaysWhatTheReportSays)
{
  ConstraintList list = test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{20}, {0, 0, 1}),
                                      test::moveBy(AtVertex{20}, {0, 0, 2}), test::moveBy(AtVertex{22}, {0, 0, 1})});
  list.constraints[3].isEnabled = false;
  NoProgress progress;
  const Report report = deform(makeModel(test::plate(6, 5), "mesh"), list, "list", {}, progress).report;
  const std::vector<CsvRecord> table = tableOf(report);
  ASSERT_EQ(table.size(), report.constraints.size() + 1);
  for (std::size_t k = 0; k < report.constraints.size(); ++k) {
    const ConstraintOutcome& outcome = report.constraints[k];
    const std::vector<std::string>& fields = table[k + 1].fields;
    EXPECT_EQ(fields[0], outcome.name);
    EXPECT_EQ(fields[3], name(outcome.status));
    EXPECT_EQ(numberIn(fields[4]), outcome.residual);
    EXPECT_EQ(numberIn(fields[5]), outcome.limit);
    EXPECT_EQ(numberIn(fields[6]), outcome.gap);
    EXPECT_EQ(numberIn(fields[9]), outcome.sensitivity);
    EXPECT_EQ(numberIn(fields[10]), outcome.multiplier);
  }
  EXPECT_EQ(table[3].fields[3], "conflicting");
  EXPECT_EQ(table[3].fields[7], "P1");
}

}  // namespace
}  // namespace holdfast
