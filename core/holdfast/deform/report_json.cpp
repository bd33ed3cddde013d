#include "holdfast/deform/report_json.h"

#include <nlohmann/json.hpp>

namespace holdfast {
namespace {

using Json = nlohmann::ordered_json;

// A region that overlaps hundreds of points need not list them all with numbers.
constexpr std::size_t kMaxReportedConflictSets = 20;

Json orNull(const std::optional<double>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json toJson(const Finding& finding)
{
  return {{"kind", finding.kind},
          {"count", finding.count},
          {"ids_of", finding.idsOf},
          {"ids", finding.ids},
          {"message", finding.message}};
}

Json toJson(const MeshReport& mesh)
{
  Json findings = Json::array();
  for (const Finding& finding : mesh.findings) findings.push_back(toJson(finding));
  return {{"vertices", mesh.vertices},
          {"faces", mesh.faces},
          {"components", mesh.components},
          {"bbox_diagonal", mesh.bboxDiagonal},
          {"findings", std::move(findings)}};
}

Json toJson(const Vector3& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

Json toJson(const ConflictSet& conflictSet)
{
  Json json{{"with", conflictSet.with},
            {"rows", conflictSet.rows},
            {"conflict", conflictSet.isConflict},
            {"gap", toJson(conflictSet.gap)},
            {"length", conflictSet.gap.stableNorm()}};
  if (conflictSet.isConflict) json["repair"] = {{"disable", conflictSet.disable}};
  if (conflictSet.consistentTarget) json["repair"]["consistent_target"] = toJson(*conflictSet.consistentTarget);
  return json;
}

/// The largest.
Json toJson(const std::vector<ConflictSet>& conflictSets)
{
  Json json = Json::array();
  for (std::size_t k = 0; k < std::min(conflictSets.size(), kMaxReportedConflictSets); ++k)
    json.push_back(toJson(conflictSets[k]));
  return json;
}

Json toJson(const ConstraintOutcome& outcome)
{
  return {{"name", outcome.name},
          {"type", outcome.type},
          {"rows", outcome.rows},
          {"status", name(outcome.status)},
          {"residual", orNull(outcome.residual)},
          {"limit", orNull(outcome.limit)},
          {"depends_on", outcome.dependsOn},
          {"gap", orNull(outcome.gap)},
          {"clashes", toJson(outcome.conflictSets)},
          {"clash_count", outcome.conflictSets.size()},
          {"amplification", orNull(outcome.sensitivity)},
          {"force", orNull(outcome.multiplier)}};
}

const char* stopName(const RotationIterations& iterations)
{
  return iterations.isConverged ? "converged" : "iteration_limit";
}

Json toJson(const SolveReport& solve)
{
  const bool isSolved = solve.status == SolveStatus::Ok || solve.status == SolveStatus::Conflicts;
  Json json{{"status", name(solve.status)},
            {"message", solve.message},
            {"max_residual", isSolved ? Json(solve.maxResidual) : Json(nullptr)},
            {"max_residual_relative", isSolved ? Json(solve.maxResidualRelative) : Json(nullptr)},
            {"weights", name(solve.weights)},
            {"solver", name(solve.options.kind)},
            {"backend", name(solve.options.backend)},
            {"method", solve.method},
            {"unknowns", solve.unknowns},
            {"factor_nonzeros", solve.factorNonzeros},
            {"refinement_steps", solve.refinementSteps},
            {"accuracy", isSolved ? Json(solve.accuracy) : Json(nullptr)},
            {"rotation_accuracy", orNull(solve.rotationAccuracy)},
            {"rotation_disagreement_degrees", orNull(solve.disagreementDegrees)},
            {"rotations", name(solve.rotations)},
            {"rotation_iterations", solve.iterations ? Json(solve.iterations->count) : Json(nullptr)},
            {"rotation_change", solve.iterations ? Json(solve.iterations->change) : Json(nullptr)},
            {"rotation_stop", solve.iterations ? Json(stopName(*solve.iterations)) : Json(nullptr)},
            {"seconds",
             {{"setup", solve.seconds.setup},
              {"decomposition", solve.seconds.factorization},
              {"solution", solve.seconds.solution}}}};
  if (solve.options.kind == SolverKind::Soft) json["soft_weight"] = solve.options.softWeight;
  return json;
}

}  // namespace

std::string reportToJson(const Report& report)
{
  Json constraints = Json::array();
  for (const ConstraintOutcome& outcome : report.constraints) constraints.push_back(toJson(outcome));
  const Json json{{"format", "holdfast-report"},
                  {"version", 1},
                  {"mesh", toJson(report.mesh)},
                  {"constraints", std::move(constraints)},
                  {"solve", toJson(report.solve)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace holdfast
