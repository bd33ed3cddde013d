#pragma once
/// \file
/// Constraint files (JSON, version 1) and point lists (CSV) in and out. docs/formats.md describes every key.

#include <filesystem>
#include <string>
#include <string_view>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// Reads a constraint file, ".csv" as a point list and anything else as JSON. Throws `InputError` with file, line (for
/// syntax) or JSON path (for meaning) and reason: unknown keys, wrong types, missing keys, numbers that are not
/// finite, names that repeat, weights that are negative or do not sum to 1 within `kWeightSumTolerance`, t outside
/// [0, 1], a zero axis or normal, a box turned inside out, a radius that is not positive, a curve through less than
/// three places, handles with a mistake (`validateHandle`), selections nested deeper than `kMaximumSelectionDepth`.
/// A session (`session_file.h`) is read as the constraint file that it is, what else it says is passed over.
/// Constraints without a name get "type N" with N their place in the list from 1. What depends on the mesh (ids, empty
/// selections) is checked by `makeConstraintSystem`. Time and memory are O(size of the file), which is refused above
/// 256 MiB.
[[nodiscard]] ConstraintList readConstraints(const std::filesystem::path& path);

/// The same from text that is at hand; `name` stands for the file in messages.
[[nodiscard]] ConstraintList parseConstraintsJson(std::string_view text, const std::string& name);

/// A CSV point list: header `name,x,y,z,target_x,target_y,target_z` (columns in any order, names may be empty), each
/// row a `near` point with a target. Quoted fields, CRLF and a byte order mark are understood, blank lines skipped.
/// Throws `InputError` with the line: columns that are missing, unknown or repeated, rows of another length, what is
/// not a finite number, names that repeat, other separators than commas, no row at all. `separator` is a tab for the
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
