#pragma once
/// \file
/// Records and fields of a CSV text by RFC 4180.

#include <string>
#include <string_view>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// The fields of one record, quotes taken off.
struct CsvRecord {
  Index line = 0;  ///< where it starts, from 1
  std::vector<std::string> fields;
};

/// The records of `text`, split at commas and at line ends (LF, CRLF or CR); blank lines are skipped. A field in double
/// quotes may hold commas, line ends, and quotes written twice. Throws `InputError` with the line where quotes are not
/// used so. O(size of the text).
[[nodiscard]] std::vector<CsvRecord> splitCsv(std::string_view text, std::string_view file);

}  // namespace holdfast
