#pragma once
/// \file
/// Conflicts in words: the smallest sets of constraints that cannot hold together, by how much, and what would mend it.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/report.h>
#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// For each constraint of the list the ways in which it clashes with earlier ones or repeats them, the largest gap
/// first. A way that needs all constraints of another one and more is left out. O(dependent rows times partners).
[[nodiscard]] std::vector<std::vector<ConflictSet>> conflictSetsOf(const ConstraintList& list,
                                                                   const ConstraintSystem& system,
                                                                   const Diagnosis& diagnosis);

}  // namespace holdfast
