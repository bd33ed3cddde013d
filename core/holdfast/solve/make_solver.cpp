#include <array>
#include <utility>

#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

std::string_view name(SolverKind kind)
{
  constexpr std::array kNames{"hard", "soft", "lagrange"};
  return kNames[static_cast<std::size_t>(kind)];
}

SolverResult ConstrainedSolver::edited(std::shared_ptr<const EliminatedConstraints> /*others*/) const
{
  return {nullptr, "only hard constraints are edited"};
}

SolverResult makeSolver(ConstrainedProblem problem, const SolverOptions& options)
{
  if (options.kind == SolverKind::Soft) return makeSoftSolver(std::move(problem), options.backend, options.softWeight);
  if (options.kind == SolverKind::Lagrange) return makeLagrangeSolver(std::move(problem), options.backend);
  return makeHardSolver(std::move(problem), options.backend);
}

}  // namespace holdfast
