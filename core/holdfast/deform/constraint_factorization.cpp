#include "holdfast/deform/constraint_factorization.h"

#include <algorithm>
#include <atomic>

#include <holdfast/operators/model_size.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// Of fewer points that nearly follow from one another a person can choose: that they cannot be held is an error.
constexpr std::ptrdiff_t kManyPoints = 32;

double largestOf(const std::vector<double>& values)
{
  return values.empty() ? 1 : *std::ranges::max_element(values);
}

/// Tells whether there are many points off the vertices.
bool hasManyPoints(const std::vector<ConstraintRow>& rows)
{
  return std::ranges::count_if(rows, [](const ConstraintRow& row) { return row.terms.size() > 1; }) > kManyPoints;
}

/// The solver's options for rows of A that were made for lengths in diagonals, as those of given rotations are.
SolverOptions inDiagonals(const DeformOptions& options, const SolverMesh& mesh)
{
  SolverOptions result = options.solver;
  const bool isScaled = result.kind == SolverKind::Soft && result.softWeight > 0;  // others are refused as they are
  if (isScaled && options.rotations.source == RotationSource::Given)
    result.softWeight /= rowsInDiameters(options.weights, diameterInDiagonals(mesh));
  return result;
}

}  // namespace

ConstraintFactorization::ConstraintFactorization(std::shared_ptr<const Model> model, const ModelOperators& of,
                                                 const std::vector<int>& ranks, const ConstraintSystem& itsSystem,
                                                 const DeformOptions& options, double itsTolerance)
    : system(itsSystem),
      tolerance(itsTolerance),
      eliminated(std::make_shared<const EliminatedByAxes>(system, model->solverMesh, tolerance)),
      sensitivities(std::make_shared<const std::vector<double>>(eliminated->sensitivities())),
      mayHaveFewerRows(hasManyPoints(system.rows) && !(largestSensitivity() < 1 / kLargestNeededDistance)),
      actedOn(
          std::async(std::launch::deferred, [A = of.A, eliminated = eliminated] { return ActedOn(*A, *eliminated); })),
      rotations(
          std::make_shared<RotationFactorization>(model->solverMesh, of.operators, options.solver.backend, ranks)),
      positions(
          [model = std::move(model), A = of.A, eliminated = eliminated, ranks = ranks, options = options]() mutable {
            const Columns3& rest = model->solverMesh.rest;
            return makeAxisSolvers({A, eliminated, rest.rowwise() - rest.colwise().mean(), std::move(ranks)},
                                   inDiagonals(options, model->solverMesh));
          })
{
}

ConstraintFactorization::ConstraintFactorization(const ConstraintFactorization& wanted,
                                                 std::shared_ptr<ConstraintFactorization> base)
    : system(wanted.system),
      tolerance(wanted.tolerance),
      eliminated(wanted.eliminated),
      sensitivities(wanted.sensitivities),
      mayHaveFewerRows(wanted.mayHaveFewerRows),
      actedOn(wanted.actedOn),
      rotations(wanted.rotations),
      positions([base = std::move(base), eliminated = eliminated] {
        return base->positions.result(noProgress()).value->edited(eliminated);
      }),
      isBordered(true)
{
}

bool ConstraintFactorization::serves(const ConstraintSystem& other) const
{
  std::atomic<bool> isSame = other.rows.size() == system.rows.size();
  if (isSame)
    parallelBlocks(static_cast<Index>(system.rows.size()), [&](Index r) {
      if (other.rows[r].terms != system.rows[r].terms ||
          other.rows[r].eliminatedDirections() != system.rows[r].eliminatedDirections())
        isSame = false;
    });
  return isSame && turnsAs(other);
}

bool ConstraintFactorization::turnsAs(const ConstraintSystem& other) const
{
  return std::ranges::equal(other.rotations, system.rotations, {}, &GivenRotation::unknown, &GivenRotation::unknown) &&
         other.rigidRegions == system.rigidRegions && other.flat == system.flat;
}

bool ConstraintFactorization::standsOn(const ConstraintFactorization& other) const
{
  return std::ranges::equal(eliminated->parts(), other.eliminated->parts(),
                            [](const AxisElimination& a, const AxisElimination& b) {
                              return std::ranges::equal(a.eliminated->dependencies, b.eliminated->dependencies, {},
                                                        &Dependency::row, &Dependency::row);
                            });
}

bool ConstraintFactorization::isReady()
{
  return positions.isDone() && positions.result(noProgress());
}

double ConstraintFactorization::largestSensitivity() const
{
  return largestOf(*sensitivities);
}

}  // namespace holdfast
