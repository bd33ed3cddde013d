#pragma once
/// Tables of measured points as instruments and spreadsheets write them. How they are to be read can be chosen, and a
/// row with a fault stands beside the others.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// What a column can mean, in the order of `PointTableFormat::columns`.
inline constexpr std::array<std::string_view, 7> kPointColumns{"name",     "x",        "y",       "z",
                                                               "target_x", "target_y", "target_z"};

struct PointTableFormat {
  char separator = ',';
  char decimalSign = '.';
  double scale = 1;       ///< lengths of the model in one of the table
  bool hasHeader = true;  ///< in the first row
  /// Where in a row each column is. Without a name points are numbered; without a target they go to their own place.
  std::array<std::optional<std::size_t>, kPointColumns.size()> columns;
};

struct PointTableRow {
  Index line = 0;
  std::string name;
  std::optional<PointConstraint> point;  ///< `near` its place, with a target; none if a number is missing or bad
  std::string fault;                     ///< a sentence without a full stop; empty if there is none
};

struct PointTable {
  PointTableFormat format;
  std::vector<std::string> titles;  ///< of the columns: as the header has them, else "column 1", ...
  std::vector<PointTableRow> rows;
};

/// Reads the table in `format`; if there is none, in the one that fits the text: columns by their titles, else in the
/// order of `kPointColumns`, with or without names and targets. A format without columns only says separator and scale.
/// Throws `InputError` as `splitCsv` does, for text that
/// is not UTF-8, and where there are no rows.
[[nodiscard]] PointTable readPointTable(std::string_view text, const std::string& file,
                                        const std::optional<PointTableFormat>& format = std::nullopt);

}  // namespace holdfast
