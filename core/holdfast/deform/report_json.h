#pragma once
/// The report file (JSON, version 1), and its constraints as a table (CSV). docs/formats.md describes every key.

#include <string>

#include <holdfast/deform/report.h>

namespace holdfast {

/// The text of a report file, indented, every double in its shortest exact form. Numbers that were not computed are
/// null.
[[nodiscard]] std::string reportToJson(const Report& report);

/// A header and a row for each constraint, in the order of the list; fields as RFC 4180 has them, lines end in LF,
/// every double in its shortest exact form. Numbers that were not computed are empty fields.
[[nodiscard]] std::string reportToCsv(const Report& report);

}  // namespace holdfast
