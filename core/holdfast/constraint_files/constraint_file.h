#pragma once
/// Constraint files (JSON, version 1) and point lists (CSV) in and out. docs/formats.md describes every key.

#include <filesystem>
#include <string>
#include <string_view>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// Reads a constraint file or a session (`session_file.h`), ".csv" as a point list and anything else as JSON. Throws
/// `InputError` with file, line (for syntax) or JSON path (for meaning) and reason for all that docs/formats.md does
/// not allow; `makeConstraintSystem` checks what depends on the mesh. Constraints without a name get "type N" with N
/// their place in the list from 1. Time and memory are O(size of the file), at most 256 MiB.
[[nodiscard]] ConstraintList readConstraints(const std::filesystem::path& path);

/// The same from text; `name` is that of the file in messages.
[[nodiscard]] ConstraintList parseConstraintsJson(std::string_view text, const std::string& name);

/// A CSV point list: header `name,x,y,z,target_x,target_y,target_z` (columns in any order, names may be empty), each
/// row a `near` point with a target. Throws `InputError` with the line. `separator` is a tab for the
/// cells of a spreadsheet.
[[nodiscard]] ConstraintList parsePointListCsv(std::string_view text, const std::string& name, char separator = ',');

/// The JSON text of a constraint file that reads back as `list`, every double in its shortest exact form. Throws
/// `OutputError` where `list` is not one that a file can say (names that repeat or are empty, numbers that are not
/// finite, ...): the text is read again before it is returned.
[[nodiscard]] std::string constraintsToJson(const ConstraintList& list);

/// Largest |sum of weights - 1| that counts as 1: rounding of weights with full digits, no more, because a point whose
/// weights are off by e would miss its target by e times its distance from the origin.
inline constexpr double kWeightSumTolerance = 1e-12;

/// Selections inside one another at most, the innermost included: more than anyone writes, and little enough to
/// recurse.
inline constexpr int kMaximumSelectionDepth = 100;

}  // namespace holdfast
