#include "holdfast/deform/rotation_factorization.h"

#include <fmt/format.h>

#include <holdfast/check/mesh_check.h>
#include <holdfast/deform/messages.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

const std::string kRefused = "the rotation field cannot be solved: ";

RotationProblem problemOf(const ConstraintSystem& system, const SolverMesh& mesh, std::vector<EdgeWeight> weights,
                          const std::vector<int>& ranks)
{
  RotationProblem problem{mesh.unknownCount(), std::move(weights), {}, system.rigidRegions, ranks};
  for (const GivenRotation& given : system.rotations) problem.prescribed.push_back(given.unknown);
  return problem;
}

double largestDegrees(const std::vector<RotationGap>& gaps)
{
  double largest = 0;
  for (const RotationGap& gap : gaps) largest = std::max(largest, angleDegrees(gap.difference));
  return largest;
}

/// Names the constraints that give rotations of one region which differ.
std::optional<Finding> disagreement(const RotationField& field, const ConstraintSystem& system)
{
  std::vector<Index> constraints;
  for (const RotationGap& gap : field.gaps)
    if (gap.difference.stableNorm() > kAgreeingRotations)
      constraints.insert(constraints.end(),
                         {system.rotations[gap.first].constraint, system.rotations[gap.given].constraint});
  if (constraints.empty()) return std::nullopt;
  const std::string differ =
      fmt::format("that differ by up to {:.3g} degrees; each given vertex turns by its own, the region by the first",
                  largestDegrees(field.gaps));
  return makeFinding("rotations_disagree", "constraint", std::move(constraints),
                     {"constraint gives rotations inside one rigid region " + differ,
                      "constraints give rotations inside one rigid region " + differ});
}

Columns3 valuesOf(const ConstraintSystem& system)
{
  Columns3 values(static_cast<Index>(system.rotations.size()), 3);
  for (std::size_t k = 0; k < system.rotations.size(); ++k) values.row(k) = system.rotations[k].q;
  return values;
}

}  // namespace

bool asksForRotation(const ConstraintSystem& system)
{
  return std::ranges::any_of(system.rotations, [](const GivenRotation& given) { return !given.q.isZero(0); });
}

Rotations RotationFactorization::solve(const ConstraintSystem& system, Progress& progress)
{
  if (!asksForRotation(system)) return {Columns3::Zero(mesh_.unknownCount(), 3), {}, {}, {}, {}};
  if (!field_) {
    RotationWeights weights = rotationEdgeWeights(*operators_);
    guards_ = guardFindings(weights, mesh_);
    field_.emplace(
        [problem = problemOf(system, mesh_, std::move(weights.edges), ranks_), backend = backend_]() mutable {
          const RotationProblem own = std::move(problem);  // not to be kept beside its factor
          return makeRotationFieldSolver(own, backend);
        });
  }
  const auto& [solver, noSolver] = field_->result(progress);
  if (solver == nullptr) return {{}, {}, {}, guards_, kRefused + noSolver};
  RotationField field = solver->solve(valuesOf(system));
  std::vector<Finding> findings = guards_;
  for (const std::optional<Finding>& finding :
       {accuracyWarning("low_rotation_accuracy", "the rotation field", field.accuracy), disagreement(field, system)})
    if (finding) findings.push_back(*finding);
  const std::string failure = accuracyFailure(field.accuracy);
  return {std::move(field.q), field.accuracy, largestDegrees(field.gaps), std::move(findings),
          failure.empty() ? "" : kRefused + failure};
}

void takeOver(const Rotations& rotations, Report& report)
{
  report.solve.rotationAccuracy = rotations.accuracy;
  report.solve.disagreementDegrees = rotations.disagreementDegrees;
  std::vector<Finding>& findings = report.mesh.findings;
  findings.insert(findings.end(), rotations.findings.begin(), rotations.findings.end());
}

Columns3 rotationOfDelta(const Columns3& delta, const Columns3& q)
{
  Columns3 result(q.rows(), 3);
  parallelBlocks(q.rows(), [&](Index i) { result.row(i) = shiftByRotation(q.row(i), delta.row(i)); });
  return result;
}

}  // namespace holdfast
