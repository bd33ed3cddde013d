#pragma once
/// The mesh files on which constraints keep points.

#include <filesystem>
#include <string>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// Reads the surface of each constraint that is on another mesh, each file once, and makes its path absolute. Relative
/// paths begin in `folder`. Throws `InputError` with the place in the list that `source` names where a file cannot be
/// read. A constraint that is disabled stays without its surface then.
void readGuideFiles(ConstraintList& list, const std::filesystem::path& folder, const std::string& source);

/// Returns `list` for a file in `folder`: paths to other meshes begin there, where one leads from there to them.
[[nodiscard]] ConstraintList withGuidePathsFrom(ConstraintList list, const std::filesystem::path& folder);

}  // namespace holdfast
