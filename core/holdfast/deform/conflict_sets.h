#pragma once
/// Conflicts in words: the smallest sets of constraints that cannot hold together, by how much, and what would mend it.

#include <optional>
#include <string>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// A constraint follows from others, none of which can be left out.
struct ConflictSet {
  std::vector<std::string> with;  ///< names of constraints before it, in their order; none: its part stays at rest
  Index rows = 0;                 ///< how many of its rows depend on just these
  Vector3 gap = Vector3::Zero();  ///< what it asks for less what they imply, model units: the largest of those rows
  bool isConflict = false;        ///< beyond the promise; else it only repeats them
  /// Repairs of a conflict. The constraint to disable that ends most conflicts at the price of the fewest rows, the
  /// later one of equals; and, for a point or an offset, the target that agrees with all of `with`.
  std::string disable;
  std::optional<Vector3> consistentTarget;
};

/// For each constraint of the list, the sets with which it conflicts or which it repeats, the largest gap first. A set
/// that holds all constraints of another one and more is left out. O(dependent rows times terms).
[[nodiscard]] std::vector<std::vector<ConflictSet>> conflictSetsOf(const ConstraintList& list,
                                                                   const ConstraintSystem& system,
                                                                   const Diagnosis& diagnosis);

}  // namespace holdfast
