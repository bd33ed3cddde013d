#include "holdfast/deform/report_csv.h"

#include <cmath>

#include <fmt/format.h>

#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {
namespace {

constexpr const char* kReportHeader =
    "name,type,rows,status,residual,limit,gap,depends_on,clash_count,amplification,force\n";

std::string orEmpty(const std::optional<double>& value)
{
  return value && std::isfinite(*value) ? std::string(NumberText(*value).view()) : std::string();
}

std::string row(const ConstraintOutcome& outcome)
{
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csvField(outcome.name), csvField(outcome.type), outcome.rows,
                     name(outcome.status), orEmpty(outcome.residual), orEmpty(outcome.limit), orEmpty(outcome.gap),
                     csvField(fmt::format("{}", fmt::join(outcome.dependsOn, "; "))), outcome.conflictSets.size(),
                     orEmpty(outcome.sensitivity), orEmpty(outcome.multiplier));
}

}  // namespace

std::string reportToCsv(const Report& report)
{
  std::string csv = kReportHeader;
  for (const ConstraintOutcome& outcome : report.constraints) csv += row(outcome);
  return csv;
}

}  // namespace holdfast
