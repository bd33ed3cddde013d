#pragma once
/// These functions find from the text of a table of points how it is written.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraint_files/point_tables.h>
#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {

/// Returns `field` without the blanks at its ends. Blanks that do not break (U+00A0 and its kin) are among them.
[[nodiscard]] std::string_view withoutBlanks(std::string_view field);

/// Reads the number in a field. Blanks around it do not matter, nor do unbreakable ones between groups of three digits.
/// A minus may be the sign U+2212. With decimal commas a point makes no number: it could part thousands.
[[nodiscard]] ParsedNumber<double> numberInField(std::string_view field, char decimalSign);

/// The key of a title is its words in lower case and in one ("targetx"). Its unit ("mm") may be empty.
struct ColumnTitle {
  std::string key;
  std::string unit;
};
[[nodiscard]] ColumnTitle partsOf(std::string_view title);

/// Returns the unit that a field names alone, as in a row of units below the titles. Returns an empty text for anything
/// else.
[[nodiscard]] std::string unitIn(std::string_view field);

/// A preamble stands before the table. It has empty lines, comments (# or //), and a line such as "sep=;".
struct TablePreamble {
  std::size_t size = 0;  ///< bytes before the table; the marker of a comment that holds the titles is one of them
  Index lines = 0;       ///< before the first line of the table
  std::optional<char> separator;
};
[[nodiscard]] TablePreamble preambleOf(std::string_view text);

/// Returns the separator of the table at the beginning of `text`.
[[nodiscard]] char separatorOf(std::string_view text);

/// Tells whether a line names x, y and z.
[[nodiscard]] bool isHeaderLine(std::string_view line);
/// Tells whether a line has three numbers.
[[nodiscard]] bool isRowLine(std::string_view line);

/// Holds the format that was found, and what else titles say.
struct FoundFormat {
  PointTableFormat format;
  std::string units;
  std::optional<PointTableDoubt> doubt;
};
/// Finds the format of `records`, of which there is at least one.
[[nodiscard]] FoundFormat formatOf(const std::vector<CsvRecord>& records, char separator);

/// Returns the doubt about a column that is needed and that no title names. Its reason names the title that may have
/// been meant.
[[nodiscard]] PointTableDoubt missingColumn(std::size_t column, const std::vector<std::string>& titles);

}  // namespace holdfast
