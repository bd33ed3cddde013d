#include "holdfast/deform/constraint_factorization.h"

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
  return a.rigidRegions == b.rigidRegions &&
         std::equal(a.rotations.begin(), a.rotations.end(), b.rotations.begin(), b.rotations.end(),
                    [](const GivenRotation& x, const GivenRotation& y) { return x.unknown == y.unknown; });
}

Columns3 aboutTheirMean(const Positions& positions)
{
  return positions.rowwise() - positions.colwise().mean();
}

}  // namespace

ConstraintFactorization::ConstraintFactorization(const Model& model, std::shared_ptr<const Operators> operators,
                                                 const ConstraintSystem& system, const DeformOptions& options)
    : system_(system),
      eliminated_(std::make_shared<const EliminatedConstraints>(eliminate(system, model.solverMesh))),
      sensitivities_(eliminated_->elimination.sensitivities()),
      rotations_(model.solverMesh, options.weights, options.solver.backend),
      positions_([operators = std::move(operators), eliminated = eliminated_,
                  rest = aboutTheirMean(model.solverMesh.rest), options = options.solver]() mutable {
        return makeSolver({weightedRows(*operators), *eliminated, std::move(rest)}, options);
      })
{
}

bool ConstraintFactorization::serves(const ConstraintSystem& system) const
{
  return haveSameRows(system, system_) && haveSameRotations(system, system_);
}

Rotations ConstraintFactorization::rotations(const ConstraintSystem& system, Progress& progress)
{
  if (!rotations_.isReady()) progress.step("solving the rotation field");
  return rotations_.solve(system, progress);
}

const SolverResult& ConstraintFactorization::positions(Progress& progress)
{
  if (!positions_.isDone()) progress.step(fmt::format("factorising {} unknowns", eliminated_->elimination.Q2().cols()));
  return positions_.result(progress);
}

}  // namespace holdfast
