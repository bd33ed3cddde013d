#pragma once
/// Constraint files (JSON, version 1) and point lists (CSV) in and out. docs/formats.md describes every key.

#include <filesystem>
#include <string>
#include <string_view>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// Reads a constraint file or a session, ".csv" as a point list and anything else as JSON; at most 256 MiB. Throws
/// `InputError` with line (for syntax) or JSON path (for meaning) for all that docs/formats.md does not allow; what
/// depends on the mesh is checked later. Constraints without a name get "type N", N their place from 1. O(size).
[[nodiscard]] ConstraintList readConstraints(const std::filesystem::path& path);

/// The same from text; `name` is that of the file in messages.
[[nodiscard]] ConstraintList parseConstraintsJson(std::string_view text, const std::string& name);

/// A CSV point list: header `name,x,y,z,target_x,target_y,target_z` (columns in any order, names may be empty), each
/// row a `near` point with a target; cells of a spreadsheet have tabs as separators. Throws `InputError` with the line.
[[nodiscard]] ConstraintList parsePointListCsv(std::string_view text, const std::string& name, char separator = ',');

/// The text of a constraint file that reads back as `list`, every double in its shortest exact form. Throws
/// `OutputError` where no file can say `list` (names that repeat or are empty, numbers that are not finite, ...).
[[nodiscard]] std::string constraintsToJson(const ConstraintList& list);

/// Largest |sum of weights - 1| that counts as 1, which is rounding: a point whose weights are off by e would miss its
/// target by e times its distance from the origin.
inline constexpr double kWeightSumTolerance = 1e-12;

/// Selections inside one another at most, the innermost included.
inline constexpr int kMaximumSelectionDepth = 100;

}  // namespace holdfast
