#pragma once
/// Instruments and spreadsheets write tables of points in their own ways. How a table is to be read is found, and can
/// be chosen. A row with a fault stands beside the others. Point lists are read by this as well.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/words/error.h>

namespace holdfast {

/// A column can mean one of these. They are in the order of `PointTableFormat::columns`.
inline constexpr std::array<std::string_view, 7> kPointColumns{"name",     "x",        "y",       "z",
                                                               "target_x", "target_y", "target_z"};

/// The coordinates of places and of targets begin here among `kPointColumns`.
inline constexpr std::size_t kFirstPlaceColumn = 1;
inline constexpr std::size_t kFirstTargetColumn = 4;

/// These separate fields. A blank stands for any number of blanks and tabs. They are tried in this order.
inline constexpr std::array kSeparators{';', '\t', ',', ' '};

struct PointTableFormat {
  char separator = ',';
  char decimalSign = '.';
  double scale = 1;       ///< lengths of the model in one of the table
  bool hasHeader = true;  ///< in the first row
  /// Says where in a row each column is. Without a name points are numbered. Without a target they go to their own
  /// place.
  std::array<std::optional<std::size_t>, kPointColumns.size()> columns;
};

struct PointTableRow {
  Index line = 0;
  std::string name;
  std::optional<PointConstraint> point;  ///< `near` its place, with a target; none if a number is missing or bad
  std::vector<ExtraText> extra;          ///< what other columns say, without empty fields
  std::string column;                    ///< at fault: "z"; empty where it is the whole row
  std::string fault;                     ///< what is wrong and what to do, without a full stop; empty if nothing is
};

/// Returns the fault with its column: "column z: "two" is not a number".
[[nodiscard]] std::string faultText(const PointTableRow& row);

/// A doubt says why the meaning of columns is only guessed.
struct PointTableDoubt {
  std::string column;  ///< empty where it is the whole header
  std::string reason;
};

struct PointTable {
  PointTableFormat format;
  std::vector<std::string> titles;  ///< of the columns, all different: as the header has them, else "column 1", ...
  Index firstLine = 1;              ///< of the header, or of the first row
  std::string units;                ///< as titles have them: "mm"; empty where they name none
  std::optional<PointTableDoubt> doubt;
  std::vector<PointTableRow> rows;
};

/// Reads the table in `format`. If there is none, it reads the table in the format that fits the text. Columns are then
/// found by their titles, else in the order of `kPointColumns`, with or without names and targets. A format without
/// columns only says separator and scale. docs/formats.md lists what is understood. Throws `InputError` as `splitCsv`
/// does, for text that is not UTF-8, and where there are no rows. O(size).
[[nodiscard]] PointTable readPointTable(std::string_view text, const std::string& file,
                                        const std::optional<PointTableFormat>& format = std::nullopt);

}  // namespace holdfast
