#include "holdfast/solve/axis_solvers.h"

#include <algorithm>
#include <utility>

namespace holdfast {

AxisSolvers::AxisSolvers(std::shared_ptr<const EliminatedByAxes> eliminated, Solvers solvers)
    : eliminated_(std::move(eliminated)), solvers_(std::move(solvers))
{
}

Displacement AxisSolvers::solve(const std::vector<RowTargets>& targets, const Columns3& f) const
{
  if (eliminated_->isOne()) return solvers_.front()->solve(targets.front(), f);
  std::vector<Displacement> parts;
  for (std::size_t k = 0; k < solvers_.size(); ++k)
    parts.push_back(solvers_[k]->solve(targets[k], eliminated_->along(k, f)));
  return joined(std::move(parts));
}

Displacement AxisSolvers::solveFrom(Displacement&& near, const std::vector<RowTargets>& targets,
                                    const Columns3& f) const
{
  if (eliminated_->isOne()) return solvers_.front()->solveFrom(std::move(near), targets.front(), f);
  std::vector<Displacement> parts;
  for (std::size_t k = 0; k < solvers_.size(); ++k)
    parts.push_back(solvers_[k]->solveFrom(partOf(near, k), targets[k], eliminated_->along(k, f)));
  return joined(std::move(parts));
}

void AxisSolvers::meet(const std::vector<RowTargets>& targets, Columns3& u) const
{
  if (eliminated_->isOne()) return solvers_.front()->meet(targets.front(), u);
  std::vector<Columns3> parts;
  for (std::size_t k = 0; k < solvers_.size(); ++k)
    solvers_[k]->meet(targets[k], parts.emplace_back(eliminated_->along(k, u)));
  u = eliminated_->joined(std::move(parts));
}

Displacement AxisSolvers::joined(std::vector<Displacement> ofParts) const
{
  if (eliminated_->isOne()) return std::move(ofParts.front());
  Displacement result = std::move(ofParts.front());
  std::vector<Columns3> parts{std::move(result.u)};
  for (std::size_t k = 1; k < ofParts.size(); ++k) {
    Displacement& part = ofParts[k];
    parts.push_back(std::move(part.u));
    result.corrections = std::max(result.corrections, part.corrections);
    result.accuracy = std::max(result.accuracy, part.accuracy);
    // 0 says that nothing is known of a part.
    result.left = result.left == 0 || part.left == 0 ? 0 : std::max(result.left, part.left);
    const Index before = result.multipliers.rows();
    result.multipliers.conservativeResize(before + part.multipliers.rows(), Eigen::NoChange);
    result.multipliers.bottomRows(part.multipliers.rows()) = part.multipliers;
  }
  result.u = eliminated_->joined(std::move(parts));
  return result;
}

/// The share of one part in a solution of all. Where a part has gone on without multipliers, nothing is known of it.
Displacement AxisSolvers::partOf(const Displacement& near, std::size_t part) const
{
  Displacement result{eliminated_->along(part, near.u), near.corrections, near.accuracy, near.left};
  Index before = 0;
  Index all = 0;
  for (std::size_t k = 0; k < solvers_.size(); ++k) {
    if (k < part) before += solvers_[k]->keptRows();
    all += solvers_[k]->keptRows();
  }
  if (all == near.multipliers.rows())
    result.multipliers = near.multipliers.middleRows(before, solvers_[part]->keptRows());
  else
    result.left = 0;
  return result;
}

AxisSolversResult AxisSolvers::edited(const std::shared_ptr<const EliminatedByAxes>& others) const
{
  const std::vector<AxisElimination>& before = eliminated_->parts();
  const std::vector<AxisElimination>& after = others->parts();
  if (eliminated_->frame() != others->frame() ||
      !std::ranges::equal(before, after, {}, &AxisElimination::axes, &AxisElimination::axes))
    return {nullptr, "the rows hold along other axes"};
  Solvers solvers;
  for (std::size_t k = 0; k < after.size(); ++k) {
    if (!eliminated_->isOne() && before[k].eliminated->rows == after[k].eliminated->rows) {
      solvers.push_back(solvers_[k]);
      continue;
    }
    SolverResult solver = solvers_[k]->edited(after[k].eliminated);
    if (!solver) return {nullptr, std::move(solver.failure)};
    solvers.push_back(std::move(solver.value));
  }
  return {std::make_shared<const AxisSolvers>(others, std::move(solvers))};
}

Index AxisSolvers::unknowns() const
{
  Index most = 0;
  for (const auto& solver : solvers_) most = std::max(most, solver->unknowns());
  return most;
}

Index AxisSolvers::factorNonzeros() const
{
  Index sum = 0;
  for (const auto& solver : solvers_) sum += solver->factorNonzeros();
  return sum;
}

AxisSolversResult makeAxisSolvers(AxisProblem problem, const SolverOptions& options)
{
  AxisSolvers::Solvers solvers;
  const std::size_t count = problem.eliminated->parts().size();
  for (const AxisElimination& part : problem.eliminated->parts()) {
    const bool isLast = solvers.size() + 1 == count;  // its own copies would be kept beside the factor
    SolverResult solver = makeSolver({problem.A, part.eliminated, isLast ? std::move(problem.rest) : problem.rest,
                                      isLast ? std::move(problem.ranks) : problem.ranks},
                                     options);
    if (!solver) return {nullptr, std::move(solver.failure)};
    solvers.push_back(std::move(solver.value));
  }
  return {std::make_shared<const AxisSolvers>(std::move(problem.eliminated), std::move(solvers))};
}

}  // namespace holdfast
