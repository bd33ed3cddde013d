#include "bench/steps.h"

#include <stdexcept>

namespace holdfast::bench {

SetUp setUp(const Model& model, const ConstraintList& constraints)
{
  return {makeOperators(model.solverMesh, Weights::Cotangent),
          makeConstraintSystem(constraints, model.mesh, model.solverMesh, model.locator(), "benchmark")};
}

std::unique_ptr<const ConstrainedSolver> factorized(const Model& model, const SetUp& setUp,
                                                    const EliminatedConstraints& eliminated,
                                                    const SolverOptions& options)
{
  const Columns3 centerd = model.solverMesh.rest.rowwise() - model.solverMesh.rest.colwise().mean();
  SolverResult result =
      makeSolver({std::make_shared<const TwoWayMatrix>(weightedRows(setUp.operators)),
                  std::make_shared<const EliminatedConstraints>(eliminated), centerd},
                 options);
  if (result.value == nullptr) throw std::runtime_error(result.failure);
  return std::move(result.value);
}

Displacement solution(const SetUp& setUp, const ConstrainedSolver& solver)
{
  return solver.solve({shiftsOf(setUp.system), {}}, Columns3::Zero(setUp.operators.L.rows(), 3));
}

double factorMiB(const ConstrainedSolver& solver)
{
  return static_cast<double>(solver.factorNonzeros()) * sizeof(double) / (1024 * 1024);
}

}  // namespace holdfast::bench
