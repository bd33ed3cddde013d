#include <utility>

#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

std::string_view name(SolverKind kind)
{
  switch (kind) {
    case SolverKind::Hard:
      return "hard";
    case SolverKind::Soft:
      return "soft";
    case SolverKind::Lagrange:
      return "lagrange";
  }
  return "";
}

SolverResult makeSolver(ConstrainedProblem problem, const SolverOptions& options)
{
  switch (options.kind) {
    case SolverKind::Hard:
      return makeHardSolver(std::move(problem), options.backend);
    case SolverKind::Soft:
      return makeSoftSolver(std::move(problem), options.backend, options.softWeight);
    case SolverKind::Lagrange:
      return makeLagrangeSolver(std::move(problem), options.backend);
  }
  return {nullptr, "there is no such solver"};
}

}  // namespace holdfast
