#include "holdfast/deform/rotation_factorization.h"

#include <fmt/format.h>

#include <holdfast/check/mesh_check.h>
#include <holdfast/constraints/axis_systems.h>
#include <holdfast/deform/messages.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

const std::string kRefused = "the rotation field cannot be solved: ";

/// Given rotations come first, so that they stand where a flat unknown has one.
RotationProblem problemOf(const ConstraintSystem& system, const std::vector<Index>& flat, const SolverMesh& mesh,
                          std::vector<EdgeWeight> weights, const std::vector<int>& ranks)
{
  RotationProblem problem{mesh.unknownCount(), std::move(weights), {}, system.rigidRegions, ranks};
  for (const GivenRotation& given : system.rotations) problem.prescribed.push_back(given.unknown);
  problem.prescribed.insert(problem.prescribed.end(), flat.begin(), flat.end());
  return problem;
}

/// Flat unknowns as rows: across its normal the rotation of each is 0. Without those at odds with most.
std::vector<ConstraintRow> rowsOfFlat(const std::vector<FlatRotation>& flat)
{
  std::vector<ConstraintRow> rows;
  for (const FlatRotation& some : flat) {
    ConstraintRow& row = rows.emplace_back();
    row.terms = {{some.unknown, 1.0}};
    row.directions = RowDirections::across(some.normal);
  }
  const std::vector<Index> atOdds = rowsAtOdds(rows);
  std::vector<ConstraintRow> kept;
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (!std::ranges::binary_search(atOdds, static_cast<Index>(r))) kept.push_back(std::move(rows[r]));
  return kept;
}

/// The gaps between given rotations, in model coordinates.
std::vector<RotationGap> gapsOfGiven(std::vector<RotationGap> gaps, Index givenCount, const Eigen::Matrix3d& frame)
{
  std::erase_if(gaps, [&](const RotationGap& gap) { return gap.given >= givenCount; });
  for (RotationGap& gap : gaps) gap.difference = frame * gap.difference;
  return gaps;
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
  if (fields_.empty()) prepare(system);
  const Columns3 given = valuesOf(system);
  RotationField field;
  std::vector<Columns3> parts;
  for (AxisField& some : fields_) {
    const auto& [solver, noSolver] = some.field->result(progress);
    if (solver == nullptr) return {{}, {}, {}, guards_, kRefused + noSolver};
    Columns3 values = fields_.size() == 1 ? given : Columns3(given * frame_);
    values.conservativeResizeLike(Columns3::Zero(given.rows() + some.flat, 3));
    RotationField its = solver->solve(values);
    field.accuracy = std::max(field.accuracy, its.accuracy);
    field.gaps = gapsOfGiven(std::move(its.gaps), given.rows(), frame_);
    if (fields_.size() > 1) its.q = alongAxes(std::move(its.q), some.axes, Eigen::Matrix3d::Identity());
    parts.push_back(std::move(its.q));
  }
  field.q = parts.size() == 1 ? std::move(parts.front()) : joinedAxes(std::move(parts), frame_);
  std::vector<Finding> findings = guards_;
  for (const std::optional<Finding>& finding :
       {accuracyWarning("low_rotation_accuracy", "the rotation field", field.accuracy), disagreement(field, system)})
    if (finding) findings.push_back(*finding);
  const std::string failure = accuracyFailure(field.accuracy);
  return {std::move(field.q), field.accuracy, largestDegrees(field.gaps), std::move(findings),
          failure.empty() ? "" : kRefused + failure};
}

void RotationFactorization::prepare(const ConstraintSystem& system)
{
  RotationWeights weights = rotationEdgeWeights(*operators_);
  guards_ = guardFindings(weights, mesh_);
  ConstraintSystem flat;
  flat.rows = rowsOfFlat(system.flat);
  frame_ = commonFrame(flat.rows).value_or(Eigen::Matrix3d::Identity());
  const std::vector<AxisSystem> systems = axisSystems(flat, frame_);
  for (const AxisSystem& some : systems) {
    std::vector<Index> unknowns;
    for (const Index row : some.rows) unknowns.push_back(flat.rows[row].terms.front().index);
    const bool isLast = &some == &systems.back();
    auto make = [problem =
                     problemOf(system, unknowns, mesh_, isLast ? std::move(weights.edges) : weights.edges, ranks_),
                 backend = backend_]() mutable {
      const RotationProblem own = std::move(problem);  // not to be kept beside its factor
      return makeRotationFieldSolver(own, backend);
    };
    fields_.push_back({some.axes, static_cast<Index>(unknowns.size()),
                       std::make_unique<LongStep<RotationFieldResult>>(std::move(make))});
  }
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
