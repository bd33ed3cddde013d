#include "holdfast/deform/forces.h"

#include <utility>

#include <holdfast/threads/parallel.h>

namespace holdfast {

ActedOn::ActedOn(const EnergyMatrix& A, const EliminatedByAxes& constraints)
    : unknowns(static_cast<std::size_t>(A.cols())), rows(static_cast<std::size_t>(A.rows()))
{
  for (const AxisElimination& part : constraints.parts())
    for (const RowTerms& row : part.eliminated->rows)
      for (const Term& term : row) {
        if (std::exchange(unknowns[term.index], 1) != 0) continue;
        A.forEachInColumn(term.index, [&](Index k, double /*value*/) { rows[k] = 1; });
      }
}

Columns3 forcesAtUnknowns(const EnergyMatrix& A, const ActedOn& actedOn, const Columns3& u, const Columns3& f,
                          double diagonal)
{
  // At the minimum the gradient of the energy is what the constraints hold: A^T (A u - f) = B^T l.
  Columns3 missed(f.rows(), 3);
  parallelBlocks(f.rows(), [&](Index k) {
    if (actedOn.rows[k] != 0) missed.row(k) = f.row(k) - A.rowTimes(k, u);
  });
  Columns3 gradient(u.rows(), 3);
  parallelBlocks(u.rows(), [&](Index k) {
    gradient.row(k).setZero();
    if (actedOn.unknowns[k] != 0) gradient.row(k) = A.columnTimes(k, missed) / -diagonal;
  });
  return gradient;
}

}  // namespace holdfast
