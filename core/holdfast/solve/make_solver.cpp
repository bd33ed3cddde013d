#include <array>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

std::string_view name(SolverKind kind)
{
  constexpr std::array kNames{"hard", "soft", "lagrange"};
  return kNames[static_cast<std::size_t>(kind)];
}

SolverResult ConstrainedSolver::edited(const std::shared_ptr<const EliminatedConstraints>& /*others*/) const
{
  return {nullptr, "only hard constraints are edited"};
}

SolverResult makeSolver(ConstrainedProblem problem, const SolverOptions& options)
{
  if (!isBuilt(options.backend))
    return {nullptr, fmt::format("the backend {} is not part of this program", name(options.backend))};
  if (options.kind == SolverKind::Soft && !(options.softWeight > 0 && std::isfinite(options.softWeight)))
    return {nullptr, fmt::format("the soft weight is {}; it has to be positive", options.softWeight)};
  if (options.kind == SolverKind::Soft) return makeSoftSolver(std::move(problem), options.backend, options.softWeight);
  if (options.kind == SolverKind::Lagrange) return makeLagrangeSolver(problem, options.backend);
  return makeHardSolver(std::move(problem), options.backend);
}

}  // namespace holdfast
