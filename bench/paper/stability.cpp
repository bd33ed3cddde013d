#include "bench/paper/stability.h"

#include <limits>

#include <fmt/format.h>

#include <holdfast/operators/operators.h>

namespace holdfast::paper {
namespace {

void measureOne(const BentMesh& bent, const BentProblem& problem, StabilityRow& row)
{
  const Result<ReducedProblem> reduced = reducedProblem(bent, problem, row.method);
  Reference reference{Columns3::Constant(problem.f.rows(), 3, std::numeric_limits<double>::quiet_NaN())};
  if (reduced) {
    reference = quadrupleSolution(bent, problem, reduced.value, row.method);
    row.condition = conditionOf(reduced.value);
  }
  row.referenceError = reference.lastCorrection;
  row.inSingle = solvedInSingle(bent, problem, row.method, reference.u);
  row.inDouble = solvedInDouble(bent, problem, row.method, reference.u);
  row.byProduct = solvedByProduct(bent, problem, row.method, reference.u);
}

}  // namespace

std::string text(const Method& method)
{
  if (method.kind == SolverKind::Soft) return fmt::format("soft {:g}", method.weight);
  return std::string(name(method.kind));
}

std::vector<Method> allMethods()
{
  std::vector<Method> methods;
  for (const double weight : {1., 5., 10., 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8})
    methods.push_back({SolverKind::Soft, weight});
  methods.push_back({SolverKind::Lagrange});
  methods.push_back({SolverKind::Hard});
  return methods;
}

void measureStability(const std::string& name, const Mesh& mesh, const std::vector<Method>& methods,
                      const std::function<void(const StabilityRow&)>& tell)
{
  const BentMesh bent = bentMesh(mesh);
  for (const Weights weights : {Weights::Uniform, Weights::CotangentPaper, Weights::Cotangent}) {
    const BentProblem problem = bentProblem(bent, weights);
    for (const Method& method : methods) {
      StabilityRow row{name, bent.model.solverMesh.unknownCount(), weights, method, {}, {}, {}};
      measureOne(bent, problem, row);
      tell(row);
    }
  }
}

}  // namespace holdfast::paper
