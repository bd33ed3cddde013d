#pragma once
/// Constraint files (JSON, version 1) and point lists (CSV) in and out. docs/formats.md describes every key.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/constraints/skipped_row.h>

namespace holdfast {

/// Reads a constraint file or a session as JSON, and as a point list what `isPointList` says; at most 256 MiB. Throws
/// `InputError` with line (for syntax) or JSON path (for meaning) for all that docs/formats.md does not allow; what
/// depends on the mesh is checked later. Constraints without a name get "type N", N their place from 1. O(size).
[[nodiscard]] ConstraintList readConstraints(const std::filesystem::path& path);

/// What names of point lists end in, in lower case. Files with other names than the first may also be JSON.
inline constexpr std::array<std::string_view, 5> kPointListExtensions{".csv", ".tsv", ".txt", ".asc", ".xyz"};

/// Whether the name is that of a point list, in any letter case, and the text is no JSON unless the name ends in .csv.
[[nodiscard]] bool isPointList(const std::filesystem::path& path, std::string_view text);

/// The same from text; `name` is that of the file in messages.
[[nodiscard]] ConstraintList parseConstraintsJson(std::string_view text, const std::string& name);

/// What becomes of rows that cannot be read.
enum class BadRows { Refuse, Skip };

struct PointList {
  ConstraintList list;
  std::vector<SkippedRow> skippedRows;  ///< none where bad rows are refused
};

/// A table of points: each row a `near` point with a target. docs/formats.md says what is understood. Throws
/// `InputError` with the line for a table whose columns are not clear, for a bad row unless bad rows are skipped, and
/// where no row is left.
[[nodiscard]] PointList parsePointList(std::string_view text, const std::string& name, BadRows badRows);

/// The list of one without bad rows.
[[nodiscard]] ConstraintList parsePointListCsv(std::string_view text, const std::string& name);

/// The text of a constraint file that reads back as `list`, every double in its shortest exact form. Throws
/// `OutputError` where no file can say `list` (names that repeat or are empty, numbers that are not finite, ...).
[[nodiscard]] std::string constraintsToJson(const ConstraintList& list);

/// Largest |sum of weights - 1| that counts as 1, which is rounding: a point whose weights are off by e would miss its
/// target by e times its distance from the origin.
inline constexpr double kWeightSumTolerance = 1e-12;

/// Selections inside one another at most, the innermost included.
inline constexpr int kMaximumSelectionDepth = 100;

}  // namespace holdfast
