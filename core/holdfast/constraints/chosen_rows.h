#pragma once
/// Rows whose targets are chosen: which they are beside those with tolerances, and how many there may be.

#include <string>

#include <holdfast/constraints/constraint_system.h>

namespace holdfast {

/// Lets rows whose directions are at odds with the frame of most others go to places that are chosen in these. Throws
/// `InputError` where they are too many, with the first constraint of `list` that has one. `source` names the list.
void chooseRowsAtOdds(ConstraintSystem& system, const ConstraintList& list, const std::string& source);

/// Throws `InputError` where more than `kMostTolerantPoints` rows are chosen, and one of them, the first of which is
/// named, is not chosen along each coordinate by itself.
void requireFewTolerant(const ConstraintSystem& system, const ConstraintList& list, const std::string& source);

/// Returns the unknowns of the triangles that lie along a plane with this normal (of length 1) and have all corners
/// among `unknowns`, ascending. O(T).
[[nodiscard]] std::vector<Index> flatAlong(const SolverMesh& mesh, const std::vector<Index>& unknowns,
                                           const Vector3& normal);

}  // namespace holdfast
