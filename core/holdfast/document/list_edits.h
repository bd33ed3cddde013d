#pragma once
/// These functions edit lists of constraints, as a table offers them. Each makes a new list and leaves the old one as
/// it is. Places in a list count from 0 and are within it. Names stay unique.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

[[nodiscard]] std::optional<Index> indexOf(const ConstraintList& list, std::string_view name);

/// Returns the first of `stem` 1, `stem` 2, ... that no constraint is called: "P1", "P2" for "P".
[[nodiscard]] std::string unusedName(const ConstraintList& list, std::string_view stem);

/// These throw `InputError` for a name that is empty or taken.
[[nodiscard]] ConstraintList added(ConstraintList list, Constraint constraint);
[[nodiscard]] ConstraintList renamed(ConstraintList list, Index index, std::string name);

/// Returns the list without the constraints at `indices`.
[[nodiscard]] ConstraintList removed(const ConstraintList& list, const std::vector<Index>& indices);
/// Returns the constraints at `indices` alone, in the order of the list.
[[nodiscard]] ConstraintList extracted(const ConstraintList& list, const std::vector<Index>& indices);

/// Moves the constraints at `indices`, in their order, in front of the one that is at `before` now, or to the end.
[[nodiscard]] ConstraintList moved(ConstraintList list, const std::vector<Index>& indices, Index before);

enum class Enabling { Enabled, Disabled };

[[nodiscard]] ConstraintList withEnabled(ConstraintList list, const std::vector<Index>& indices, Enabling enabling);

/// Returns `list` with all of `other` at the end. Names that are taken get another number: "P1" becomes "P2", "base"
/// becomes "base 2". Units are those of `list`, if it has any.
[[nodiscard]] ConstraintList pasted(ConstraintList list, ConstraintList other);

}  // namespace holdfast
