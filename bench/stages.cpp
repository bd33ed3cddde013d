#include "bench/stages.h"

#include <stdexcept>

namespace holdfast::bench {

SetUp setUp(const Model& model, const ConstraintList& constraints)
{
  return {makeOperators(model.solverMesh, Weights::Cotangent),
          makeConstraintSystem(constraints, model.mesh, model.triangulation, model.solverMesh, "benchmark")};
}

std::unique_ptr<const DeformationSolver> factorized(const Model& model, const SetUp& setUp,
                                                    const EliminatedConstraints& eliminated,
                                                    const SolverOptions& options)
{
  const Columns3 centred = model.solverMesh.rest.rowwise() - model.solverMesh.rest.colwise().mean();
  DecompositionAttempt attempt = decompose({weightedRows(setUp.operators), eliminated, centred}, options);
  if (attempt.solver == nullptr) throw std::runtime_error(attempt.failure);
  return std::move(attempt.solver);
}

Displacement solution(const SetUp& setUp, const DeformationSolver& solver)
{
  return solver.solve({shiftsOf(setUp.system), {}}, Columns3::Zero(setUp.operators.L.rows(), 3));
}

double factorMiB(const DeformationSolver& solver)
{
  return static_cast<double>(solver.factorNonzeros()) * sizeof(double) / (1024 * 1024);
}

}  // namespace holdfast::bench
