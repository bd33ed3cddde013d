#include "holdfast/rotation/rotation_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <holdfast/solve/corrected_solve.h>

namespace holdfast {
namespace {

std::vector<RotationGap> rotationGaps(const RotationUnknowns& unknowns, const Columns3& values)
{
  std::vector<RotationGap> gaps;
  for (Index k = 0; k < values.rows(); ++k) {
    const Vector3 difference = values.row(k) - values.row(unknowns.leaderOf[k]);
    if (!difference.isZero(0)) gaps.push_back({k, unknowns.leaderOf[k], difference});
  }
  return gaps;
}

std::string notFiniteMessage(const EdgeWeight& edge)
{
  return fmt::format(
      "the weight of the edge between unknowns {} and {} is not finite, because a face there has no area; use the "
      "weights \"cotangent\" or repair that face",
      edge.i, edge.j);
}

RotationSystem systemOf(const std::vector<EdgeWeight>& weights, const RotationUnknowns& unknowns)
{
  const bool hasNegative =
      std::any_of(weights.begin(), weights.end(), [](const auto& edge) { return edge.weight < 0; });
  return hasNegative ? balanceRows(weights, unknowns) : energyRows(weights, unknowns);
}

}  // namespace

RotationFieldSolver::RotationFieldSolver(RotationUnknowns unknowns, std::vector<RotationPull> pulls,
                                         ScaledColumns scaled, std::unique_ptr<const LeastSquaresFactor> factor)
    : unknowns_(std::move(unknowns)), pulls_(std::move(pulls)), scaled_(std::move(scaled)), factor_(std::move(factor))
{
}

RotationField RotationFieldSolver::solve(const Columns3& values) const
{
  assert(values.rows() == static_cast<Index>(unknowns_.leaderOf.size()));
  Columns3 f = Columns3::Zero(scaled_.C->rows(), 3);
  for (const auto& [row, weight, given, reference] : pulls_)
    f.row(row) += weight * (values.row(given) - values.row(reference));
  const CorrectedSolution z = correctedSolve(*factor_, *scaled_.C, scaled_.scale, f);

  const auto n = static_cast<Index>(unknowns_.givenOf.size());
  RotationField field{Columns3::Zero(n, 3), z.corrections, z.accuracy, rotationGaps(unknowns_, values)};
  for (Index i = 0; i < n; ++i) {
    const Index column = unknowns_.columnOf[i];
    if (unknowns_.givenOf[i] >= 0)
      field.q.row(i) = values.row(unknowns_.givenOf[i]);
    else if (column >= 0)
      field.q.row(i) = values.row(unknowns_.referenceOf[column]) + scaled_.scale[column] * z.z.row(column);
  }
  return field;
}

RotationFieldResult makeRotationFieldSolver(const RotationProblem& problem, Backend backend)
{
  for (const EdgeWeight& edge : problem.weights)
    if (!std::isfinite(edge.weight)) return {nullptr, notFiniteMessage(edge)};
  RotationUnknowns unknowns = rotationUnknowns(problem);
  RotationSystem system = systemOf(problem.weights, unknowns);
  Result<ScaledColumns> columns = scaleColumns(system.C);
  if (!columns) return {nullptr, "the rotation field: " + columns.failure};
  ScaledColumns& scaled = columns.value;
  // A common rotation: what edges resist least, and so the hardest to find.
  const Columns3 probe = scaled.scale.cwiseInverse().replicate(1, 3);
  FactorResult result = factorize(scaled.C, backend, probe);
  if (!result) return {nullptr, "the rotation field: " + result.failure};
  return {std::make_unique<RotationFieldSolver>(std::move(unknowns), std::move(system.pulls), std::move(scaled),
                                                std::move(result.value))};
}

}  // namespace holdfast
