#pragma once
/// Forces say how hard constraints pull at each unknown. They hold a displacement against its energy |A u - f|^2 / 2.

#include <vector>

#include <holdfast/elimination/axis_elimination.h>
#include <holdfast/numbers/term.h>
#include <holdfast/operators/energy_matrix.h>

namespace holdfast {

/// The places where constraints act.
struct ActedOn {
  ActedOn(const EnergyMatrix& A, const EliminatedByAxes& constraints);

  std::vector<char> unknowns;  ///< 1 where a constraint names the unknown
  std::vector<char> rows;      ///< 1 where a row of A names one of these unknowns
};

/// Returns A^T (f - A u) at the unknowns that constraints act on and 0 at all others, n x 3. Lengths are in diagonals:
/// the result has no units. O(entries of A where constraints act).
[[nodiscard]] Columns3 forcesAtUnknowns(const EnergyMatrix& A, const ActedOn& actedOn, const Columns3& u,
                                        const Columns3& f, double diagonal);

}  // namespace holdfast
