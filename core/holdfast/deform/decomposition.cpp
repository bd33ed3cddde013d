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

}  // namespace

Decomposition::Decomposition(const Model& model, std::shared_ptr<const Operators> operators,
                             const ConstraintSystem& system, const DeformOptions& options)
    : model_(model),
      operators_(std::move(operators)),
      options_(options.solver),
      system_(system),
      eliminated_(eliminate(system, model.solverMesh)),
      amplifications_(eliminated_.elimination.amplifications()),
      rotations_(model.solverMesh, options.weights, options.solver.backend)
{
}

bool Decomposition::serves(const ConstraintSystem& system) const
{
  return haveSameRows(system, system_) && haveSameRotations(system, system_);
}

Rotations Decomposition::rotations(const ConstraintSystem& system, Progress& progress)
{
  if (!rotations_.isReady()) progress.stage("solving the rotation field");
  return rotations_.solve(system);
}

const DecompositionAttempt& Decomposition::positions(Progress& progress)
{
  if (positions_.solver != nullptr || !positions_.failure.empty()) return positions_;
  progress.stage(fmt::format("factorising {} unknowns", eliminated_.elimination.Q2().cols()));
  const Columns3 centred = model_.solverMesh.rest.rowwise() - model_.solverMesh.rest.colwise().mean();
  positions_ = decompose({weightedRows(*operators_), eliminated_, centred}, options_);
  return positions_;
}

}  // namespace holdfast
