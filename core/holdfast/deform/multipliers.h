#pragma once
/// \file
/// How hard each constraint pulls: the Lagrange multipliers of the rows.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/deform.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/operators/operators.h>

namespace holdfast {

/// What the constraints do to the surface, with the energy |A u - f|^2 / 2 of lengths in diagonals: no units.
struct Multipliers {
  Columns3 ofRows;      ///< rows x 3: the pull along what the row holds; zero for rows that were left out
  Columns3 ofUnknowns;  ///< n x 3: their sum where they act
};

/// The forces that hold the displacement `u` (n x 3) against A u = f. O(entries of L).
[[nodiscard]] Multipliers multipliersOf(const Operators& operators, const EliminatedConstraints& eliminated,
                                        const Columns3& u, const Columns3& f, double diagonal);

/// The sum of the lengths of its rows' forces, for every constraint of a list.
[[nodiscard]] std::vector<double> multipliersOfConstraints(const Multipliers& multipliers,
                                                           const ConstraintSystem& system, std::size_t constraintCount);

}  // namespace holdfast
