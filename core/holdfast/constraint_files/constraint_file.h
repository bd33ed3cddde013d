#pragma once
/// These functions read constraint files (JSON, version 1) and point lists (CSV), and write constraint files.
/// docs/formats.md describes every key.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/constraints/skipped_row.h>

namespace holdfast {

/// Reads a constraint file or a session as JSON. Reads it as a point list where `isPointList` says so. The file may
/// have 256 MiB at most. A constraint without a name gets "type N", where N is its place in the list, counted from 1.
/// Throws `InputError` for all that docs/formats.md does not allow, with the line (for syntax) or the JSON path (for
/// meaning). What depends on the mesh is checked later. Reads the files of meshes on which constraints keep points too
/// (`OnMesh`). O(size).
///
///     ConstraintList list = readConstraints("bracket.constraints.json");
///     list.constraints.front().isEnabled = false;
///     std::ofstream("changed.constraints.json") << constraintsToJson(list);
[[nodiscard]] ConstraintList readConstraints(const std::filesystem::path& path);

/// The names of point lists end in one of these, here in lower case. A file whose name ends in another than the first
/// may also be JSON.
inline constexpr std::array<std::string_view, 5> kPointListExtensions{".csv", ".tsv", ".txt", ".asc", ".xyz"};

/// Tells whether a file with this name and this text is a point list. Its name ends in one of `kPointListExtensions`,
/// in any letter case. Unless the name ends in .csv, a text that begins with a brace is JSON instead.
[[nodiscard]] bool isPointList(const std::filesystem::path& path, std::string_view text);

/// Reads the text of a constraint file or a session as `readConstraints` reads JSON, but for files of other meshes.
/// Messages call the file `name`.
[[nodiscard]] ConstraintList parseConstraintsJson(std::string_view text, const std::string& name);

/// A row that cannot be read is refused with an `InputError`, or skipped.
enum class BadRows { Refuse, Skip };

/// Holds what was read of a point list: its constraints, and the rows that were left out.
struct PointList {
  ConstraintList list;
  std::vector<SkippedRow> skippedRows;  ///< empty where bad rows are refused
};

/// Reads a table of points, in which each row is a `near` point with a target. docs/formats.md says what is understood.
/// Messages call the file `name`. Throws `InputError` with the line where the columns are not clear or where no row is
/// left. A bad row throws `InputError` as well, unless `badRows` is `Skip`.
[[nodiscard]] PointList parsePointList(std::string_view text, const std::string& name, BadRows badRows);

/// Reads a table as `parsePointList` does, and refuses bad rows.
[[nodiscard]] ConstraintList parsePointListCsv(std::string_view text, const std::string& name);

/// Returns the text of a constraint file that reads back as `list`. Every double has its shortest exact form. Throws
/// `OutputError` where no file can say `list` (names that repeat or are empty, numbers that are not finite, ...).
[[nodiscard]] std::string constraintsToJson(const ConstraintList& list);

/// A sum of weights counts as 1 when it is off by no more than this, which is rounding. A point whose weights are off
/// by e would miss its target by e times its distance from the origin.
inline constexpr double kWeightSumTolerance = 1e-12;

/// A file may nest this many selections inside one another, the innermost included.
inline constexpr int kMaximumSelectionDepth = 100;

}  // namespace holdfast
