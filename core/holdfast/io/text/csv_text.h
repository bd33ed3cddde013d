#pragma once
/// These functions write fields and split records of CSV texts as RFC 4180 has them.

#include <string>
#include <string_view>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns `text` as one field. It is in double quotes where it holds a comma, a quote, a line end, or blanks at an
/// end.
[[nodiscard]] std::string csvField(std::string_view text);

struct CsvRecord {
  Index line = 0;                   ///< where it starts, from 1
  std::vector<std::string> fields;  ///< quotes taken off
};

/// Splits the text at line ends (LF, CRLF or CR) into records, and these at `separator` into fields. The separator is a
/// comma, a semicolon, a tab, or a blank. A blank stands for any number of blanks and tabs. Blank lines are skipped. A
/// field in double quotes may hold separators, line ends, and quotes written twice. Where the separator is no comma,
/// other quotes are plain characters. `text` begins in line `firstLine` of the file. Throws `InputError` with the line
/// where quotes are used otherwise.
[[nodiscard]] std::vector<CsvRecord> splitCsv(std::string_view text, std::string_view file, char separator = ',',
                                              Index firstLine = 1);

}  // namespace holdfast
