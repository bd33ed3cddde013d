#include "bench/table_reporter.h"

#include <cmath>
#include <iterator>
#include <map>
#include <ostream>
#include <set>

#include <fmt/format.h>

namespace holdfast::bench {
namespace {

using Row = std::map<std::string, double>;  // by column

constexpr int kLabelWidth = 40;
constexpr int kColumnWidth = 13;

std::map<std::string, Row> rowsOf(const benchmark::UserCounters& counters)
{
  std::map<std::string, Row> rows;
  for (const auto& [name, counter] : counters) {
    const std::size_t slash = name.find('/');
    rows[name.substr(0, slash)][name.substr(slash + 1)] = counter.value;
  }
  return rows;
}

std::set<std::string> columnsOf(const std::map<std::string, Row>& rows)
{
  std::set<std::string> columns;
  for (const auto& [label, row] : rows)
    for (const auto& [column, value] : row) columns.insert(column);
  return columns;
}

std::string cell(const Row& row, const std::string& column)
{
  const auto found = row.find(column);
  if (found == row.end() || std::isnan(found->second)) return "-";
  const double value = found->second;
  return std::abs(value) >= 1000 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

}  // namespace

bool TableReporter::ReportContext(const Context& context)
{
  GetOutputStream() << fmt::format("{} cores\n", context.cpu_info.num_cpus);
  return true;
}

void TableReporter::ReportRuns(const std::vector<Run>& runs)
{
  for (const Run& run : runs) reportRun(run);
}

void TableReporter::reportRun(const Run& run)
{
  std::ostream& out = GetOutputStream();
  const auto rows = rowsOf(run.counters);
  const auto columns = columnsOf(rows);
  const std::string& name = run.run_name.function_name;
  const std::string family = name.substr(0, name.find('/'));
  if (family != family_) {
    out << fmt::format("\n== {}\n{:<{}}", family, "", kLabelWidth);
    for (const std::string& column : columns) out << fmt::format("{:>{}}", column, kColumnWidth);
    out << '\n';
    family_ = family;
  }
  const std::string subject = name.substr(name.find('/') + 1);
  for (const auto& [label, row] : rows) {
    out << fmt::format("{:<{}}", subject + ", " + label, kLabelWidth);
    for (const std::string& column : columns) out << fmt::format("{:>{}}", cell(row, column), kColumnWidth);
    out << '\n';
  }
  out << std::flush;
}

}  // namespace holdfast::bench
