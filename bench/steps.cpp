#include "bench/steps.h"

#include <stdexcept>
#include <utility>

#include <holdfast/solve/column_scaling.h>

namespace holdfast::bench {

SetUp setUp(const Model& model, const ConstraintList& constraints)
{
  const SolverMesh& mesh = model.solverMesh;
  return {std::make_shared<const EnergyMatrix>(weightedRows(makeOperators(mesh, Weights::Cotangent))),
          eliminationRanks(mesh.unknownCount(), mesh.triangles),
          makeConstraintSystem(constraints, model.mesh, mesh, model.locator(), "benchmark")};
}

std::unique_ptr<const ConstrainedSolver> factorized(const Model& model, const SetUp& setUp,
                                                    const EliminatedConstraints& eliminated, SolverKind kind)
{
  const Columns3 centered = model.solverMesh.rest.rowwise() - model.solverMesh.rest.colwise().mean();
  SolverOptions options;
  options.kind = kind;
  SolverResult result =
      makeSolver({setUp.A, std::make_shared<const EliminatedConstraints>(eliminated), centered, setUp.ranks}, options);
  if (!result) throw std::runtime_error(result.failure);
  return std::move(result.value);
}

Displacement solution(const SetUp& setUp, const ConstrainedSolver& solver)
{
  return solver.solve({shiftsOf(setUp.system), {}}, Columns3::Zero(setUp.A->rows(), 3));
}

double factorMiB(const ConstrainedSolver& solver)
{
  return static_cast<double>(solver.factorNonzeros()) * sizeof(double) / (1024 * 1024);
}

SparseMatrix normalEquations(const Model& model, const ConstraintList& constraints)
{
  const SetUp made = setUp(model, constraints);
  const EliminatedConstraints eliminated = eliminate(made.system, model.solverMesh);
  return scaleColumns(product(*made.A, orderedColumns(eliminated.elimination.Q2(), made.ranks))).value.C.gramLower();
}

}  // namespace holdfast::bench
