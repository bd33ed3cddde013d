#pragma once
/// What a report says of each constraint, as a table (CSV). docs/formats.md describes every column.

#include <string>

#include <holdfast/deform/report.h>

namespace holdfast {

/// A header and a row for each constraint, in the order of the list; fields as RFC 4180 has them, lines end in LF,
/// every double in its shortest exact form. Numbers that were not computed are empty fields.
[[nodiscard]] std::string reportToCsv(const Report& report);

}  // namespace holdfast
