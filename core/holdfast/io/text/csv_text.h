#pragma once
/// Fields and records of CSV texts as RFC 4180 has them.

#include <string>
#include <string_view>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// `text` as one field: in double quotes where it holds a comma, a quote, a line end, or blanks at an end.
[[nodiscard]] std::string csvField(std::string_view text);

struct CsvRecord {
  Index line = 0;                   ///< where it starts, from 1
  std::vector<std::string> fields;  ///< quotes taken off
};

/// Split at `separator` (a comma, a semicolon, a tab, or a blank for any number of blanks and tabs) and at line ends
/// (LF, CRLF or CR); blank lines are skipped. A field in double quotes may hold separators, line ends, and quotes
/// written twice; without commas other quotes are plain characters. `text` begins in line `firstLine` of the file.
/// Throws `InputError` with the line where quotes are used otherwise.
[[nodiscard]] std::vector<CsvRecord> splitCsv(std::string_view text, std::string_view file, char separator = ',',
                                              Index firstLine = 1);

}  // namespace holdfast
