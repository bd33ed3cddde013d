#include "holdfast/deform/multipliers.h"

#include <utility>

namespace holdfast {

Multipliers multipliersOf(const Operators& operators, const EliminatedConstraints& eliminated, const Columns3& u,
                          const Columns3& f, double diagonal)
{
  // At the minimum the gradient of the energy is what the constraints hold: A^T (A u - f) = B^T l.
  const auto W = operators.rowWeights.asDiagonal();
  const Columns3 missed = W * (operators.L * (u / diagonal)) - f / diagonal;
  Columns3 gradient = operators.L.transpose() * (W * missed);
  for (Index i = 0; i < gradient.rows(); ++i)
    if (eliminated.isHeld[i]) gradient.row(i).setZero();
  Columns3 ofRows = eliminated.elimination.multipliers(gradient);
  return {std::move(ofRows), std::move(gradient)};
}

std::vector<double> multipliersOfConstraints(const Multipliers& multipliers, const ConstraintSystem& system,
                                             std::size_t constraintCount)
{
  std::vector<double> result(constraintCount, 0);
  for (std::size_t r = 0; r < system.rows.size(); ++r)
    result[system.rows[r].constraint] += multipliers.ofRows.row(static_cast<Index>(r)).stableNorm();
  return result;
}

}  // namespace holdfast
