#include "holdfast/deform/report_json.h"

#include <cmath>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <holdfast/io/text/csv_text.h>
#include <holdfast/io/text/number_text.h>

namespace holdfast {

using Json = nlohmann::ordered_json;

/// Found by the library where it writes lists of them.
static void to_json(Json& json, const Finding& finding)
{
  json = {{"kind", finding.kind},
          {"count", finding.count},
          {"ids_of", finding.idsOf},
          {"ids", finding.ids},
          {"message", finding.message}};
}

static void to_json(Json& json, const SkippedRow& row)
{
  json = {{"line", row.line}, {"name", row.name}, {"fault", row.fault}};
}

namespace {

// A region that overlaps hundreds of points need not list them all with numbers.
constexpr std::size_t kMaxReportedConflictSets = 20;

Json orNull(const std::optional<double>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json toJson(const MeshReport& mesh)
{
  return {{"vertices", mesh.vertices},
          {"faces", mesh.faces},
          {"components", mesh.components},
          {"bbox_diagonal", mesh.bboxDiagonal},
          {"findings", mesh.findings}};
}

Json toJson(const ConflictSet& conflictSet)
{
  Json json{{"with", conflictSet.with}, {"with_count", conflictSet.withCount},
            {"rows", conflictSet.rows}, {"conflict", conflictSet.isConflict},
            {"gap", conflictSet.gap},   {"length", conflictSet.gap.stableNorm()}};
  if (conflictSet.isConflict) json["repair"] = {{"disable", conflictSet.disable}};
  if (conflictSet.isMetByFoundRotations) json["repair"]["found_rotations"] = true;
  if (conflictSet.consistentTarget) json["repair"]["consistent_target"] = *conflictSet.consistentTarget;
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
          {"depends_on_count", outcome.dependsOnCount},
          {"gap", orNull(outcome.gap)},
          {"clashes", toJson(outcome.conflictSets)},
          {"clash_count", outcome.conflictSets.size()},
          {"amplification", orNull(outcome.sensitivity)},
          {"force", orNull(outcome.multiplier)},
          {"distance", orNull(outcome.nearDistance)},
          {"off_target", orNull(outcome.offTarget)},
          {"at_bound", outcome.isAtBound ? Json(*outcome.isAtBound) : Json(nullptr)}};
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

Json toJson(const RatioVerdict& ratios)
{
  return {{"least", ratios.least}, {"most", ratios.most}, {"shrunk", ratios.shrunk}, {"grown", ratios.grown}};
}

Json toJson(const TargetMotion& motion)
{
  return {{"degrees", motion.degrees}, {"axis", motion.axis},   {"scale", motion.scale},
          {"shift", motion.shift},     {"moved", motion.moved}, {"left", motion.left}};
}

Json orNull(const std::optional<Index>& count)
{
  return count ? Json(*count) : Json(nullptr);
}

Json toJson(const ResultVerdict& result)
{
  Json motions = Json::array();
  for (const TargetMotion& motion : result.targetMotions) motions.push_back(toJson(motion));
  Json json{{"status", name(result.status)}, {"warnings", result.warnings}};
  if (result.status != ResultStatus::NotMeasured) {
    json["folds"] = {{"faces", result.foldedFaces}, {"largest_degrees", result.foldDegrees}};
    json["inverted_faces"] = orNull(result.invertedFaces);
    json["crossing_faces"] = orNull(result.crossingFaces);
    json["edges"] = toJson(result.edges);
    json["areas"] = toJson(result.areas);
    json["volumes"] = toJson(result.volumes);
    json["overshoot"] = {{"vertices", result.overshoot.vertices},
                         {"largest", result.overshoot.largest},
                         {"asked", result.overshoot.asked}};
  }
  json["target_motions"] = std::move(motions);
  return json;
}

// Of a table: what the report file calls them.
constexpr std::array kColumns{"name",  "type",     "rows",       "status",      "residual",
                              "limit", "gap",      "depends_on", "clash_count", "amplification",
                              "force", "distance", "off_target", "at_bound"};

std::string cellOf(const Json& value)
{
  if (value.is_null() || (value.is_number_float() && !std::isfinite(value.get<double>()))) return "";
  if (value.is_number_float()) return std::string(NumberText(value.get<double>()).view());
  if (value.is_array()) return csvField(fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), "; ")));
  return value.is_string() ? csvField(value.get<std::string>()) : value.dump();
}

}  // namespace

std::string reportToJson(const Report& report)
{
  Json constraints = Json::array();
  for (const ConstraintOutcome& outcome : report.constraints) constraints.push_back(toJson(outcome));
  const Json json{{"format", "holdfast-report"},        {"version", 1},
                  {"mesh", toJson(report.mesh)},        {"constraints", std::move(constraints)},
                  {"skipped_rows", report.skippedRows}, {"solve", toJson(report.solve)},
                  {"result", toJson(report.result)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string reportToCsv(const Report& report)
{
  std::string csv = fmt::format("{}\n", fmt::join(kColumns, ","));
  for (const ConstraintOutcome& outcome : report.constraints) {
    const Json json = toJson(outcome);
    std::vector<std::string> cells;
    cells.reserve(kColumns.size());
    for (const char* const column : kColumns) cells.push_back(cellOf(json[column]));
    csv += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return csv;
}

}  // namespace holdfast
