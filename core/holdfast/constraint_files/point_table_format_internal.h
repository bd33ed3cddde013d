#pragma once
/// How a table of points is written: found from its text.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraint_files/point_tables.h>
#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {

/// `field` without blanks at its ends, those that do not break (U+00A0 and its kin) among them.
[[nodiscard]] std::string_view withoutBlanks(std::string_view field);

/// The number in a field. Blanks around it do not matter, nor do unbreakable ones between groups of three digits; a
/// minus may be the sign U+2212. With decimal commas a point makes no number: it could part thousands.
[[nodiscard]] ParsedNumber<double> numberInField(std::string_view field, char decimalSign);

/// What a title says: its words in lower case and in one ("targetx"), and its unit ("mm", or empty).
struct ColumnTitle {
  std::string key;
  std::string unit;
};
[[nodiscard]] ColumnTitle partsOf(std::string_view title);

/// The unit that a field names alone, as those of a row of units below the titles; empty for anything else.
[[nodiscard]] std::string unitIn(std::string_view field);

/// What stands before the table: empty lines, comments (# or //), and a line such as "sep=;".
struct TablePreamble {
  std::size_t size = 0;  ///< bytes before the table; the marker of a comment that holds the titles is one of them
  Index lines = 0;       ///< before the first line of the table
  std::optional<char> separator;
};
[[nodiscard]] TablePreamble preambleOf(std::string_view text);

/// That of the table at the beginning of `text`.
[[nodiscard]] char separatorOf(std::string_view text);

/// Whether a line names x, y and z, and whether it has three numbers.
[[nodiscard]] bool isHeaderLine(std::string_view line);
[[nodiscard]] bool isRowLine(std::string_view line);

/// The format of `records`, one or more, and what else titles say.
struct FoundFormat {
  PointTableFormat format;
  std::string units;
  std::optional<PointTableDoubt> doubt;
};
[[nodiscard]] FoundFormat formatOf(const std::vector<CsvRecord>& records, char separator);

/// A column that is needed and that no title names; what to do names the title that may have been meant.
[[nodiscard]] PointTableDoubt missingColumn(std::size_t column, const std::vector<std::string>& titles);

}  // namespace holdfast
