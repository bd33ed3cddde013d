#include "holdfast/deform/decomposition.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace holdfast {
namespace {

bool haveSameRows(const ConstraintSystem& a, const ConstraintSystem& b)
{
  return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
                    [](const ConstraintRow& x, const ConstraintRow& y) { return x.terms == y.terms; });
}

bool haveSameRotations(const ConstraintSystem& a, const ConstraintSystem& b)
{
  return a.bodies == b.bodies &&
         std::equal(a.rotations.begin(), a.rotations.end(), b.rotations.begin(), b.rotations.end(),
                    [](const GivenRotation& x, const GivenRotation& y) { return x.unknown == y.unknown; });
}

Columns3 aboutTheirMean(const Positions& positions)
{
  return positions.rowwise() - positions.colwise().mean();
}

}  // namespace

Decomposition::Decomposition(const Model& model, std::shared_ptr<const Operators> operators,
                             const ConstraintSystem& system, const DeformOptions& options)
    : system_(system),
      eliminated_(std::make_shared<const EliminatedConstraints>(eliminate(system, model.solverMesh))),
      amplifications_(eliminated_->elimination.amplifications()),
      rotations_(model.solverMesh, options.weights, options.solver.backend),
      positions_([operators = std::move(operators), eliminated = eliminated_,
                  rest = aboutTheirMean(model.solverMesh.rest), options = options.solver]() mutable {
        return decompose({weightedRows(*operators), *eliminated, std::move(rest)}, options);
      })
{
}

bool Decomposition::serves(const ConstraintSystem& system) const
{
  return haveSameRows(system, system_) && haveSameRotations(system, system_);
}

Rotations Decomposition::rotations(const ConstraintSystem& system, Progress& progress)
{
  if (!rotations_.isReady()) progress.stage("solving the rotation field");
  return rotations_.solve(system, progress);
}

const DecompositionAttempt& Decomposition::positions(Progress& progress)
{
  if (!positions_.isDone())
    progress.stage(fmt::format("factorising {} unknowns", eliminated_->elimination.Q2().cols()));
  return positions_.result(progress);
}

}  // namespace holdfast
