#pragma once
/// These functions write a report as a file (JSON, version 1), and its constraints as a table (CSV). docs/formats.md
/// describes every key.
///
///     std::ofstream("report.json") << reportToJson(result.report);

#include <string>

#include <holdfast/deform/report.h>

namespace holdfast {

/// Returns the text of a report file, indented. Every double has its shortest exact form. Numbers that were not
/// computed are null.
[[nodiscard]] std::string reportToJson(const Report& report);

/// Returns a table with a header and a row for each constraint, in the order of the list. Fields are quoted as RFC 4180
/// says, and lines end in LF. Every double has its shortest exact form. Numbers that were not computed are empty
/// fields.
[[nodiscard]] std::string reportToCsv(const Report& report);

}  // namespace holdfast
