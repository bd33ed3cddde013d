#include "holdfast/verdict/result_check.h"

#include <algorithm>
#include <array>

namespace holdfast {
namespace {

RatioVerdict verdictOf(const Ratios& ratios)
{
  return {ratios.least, ratios.most, ratios.shrunkCount, ratios.grownCount};
}

}  // namespace

std::string_view name(ResultStatus status)
{
  constexpr std::array kNames{"not measured", "fine", "doubtful"};
  return kNames[static_cast<std::size_t>(status)];
}

ResultCheck::ResultCheck(const SolverMesh& mesh, const Positions& atRest) : mesh_(mesh), atRest_(atRest), rest_(mesh) {}

CheckedResult ResultCheck::ofFrame(const Positions& now, const ConstraintSystem& system)
{
  const DeformedSurface surface = surfaceAt(now);
  if (!overshoot_ && std::ranges::any_of(system.rows, hangsOnSeveral)) overshoot_.emplace(rest_, now.rows());
  const ShapeChange change = changeOf(surface);
  const Overshoot overshoot = overshoot_ ? overshoot_->find(surface, system) : Overshoot();
  CheckedResult checked;
  addShapeFindings(checked.findings, surface, change);
  addOvershootFindings(checked.findings, overshoot);
  ResultVerdict& verdict = checked.verdict;
  verdict.foldDegrees = change.foldDegrees;
  verdict.foldedFaces = static_cast<Index>(facesAtFolds(surface, change.foldedHinges).size());
  verdict.edges = verdictOf(change.lengths);
  verdict.areas = verdictOf(change.areas);
  verdict.volumes = verdictOf(change.volumes);
  verdict.overshoot = {static_cast<Index>(overshoot.vertices.size()), overshoot.largest, overshoot.asked};
  takeOver(checked.findings, verdict);
  return checked;
}

Findings ResultCheck::addRest(ResultVerdict& verdict, const Positions& now, const ConstraintSystem& system,
                              RotationSource rotations, Progress& progress)
{
  const DeformedSurface surface = surfaceAt(now);
  Findings findings;
  const std::vector<int> inverted = invertedTriangles(rest_, changeOf(surface).foldedHinges);
  addInverted(findings, mesh_, inverted);
  if (!crossings_) crossings_.emplace(rest_, atRest_);
  const CrossingTriangles crossing = crossings_->find(now, progress);
  addCrossing(findings, mesh_, crossing);
  addTargetFindings(findings, mesh_, system, rotations);
  addLevelRegions(findings, levelRegions(surface, system), rotations);
  verdict.invertedFaces = static_cast<Index>(facesOf(mesh_, inverted).size());
  verdict.crossingFaces = static_cast<Index>(facesOf(mesh_, crossing.triangles).size());
  verdict.targetMotions = targetMotionsOf(wholeMotions(system, mesh_));
  takeOver(findings, verdict);
  return findings;
}

void takeOver(const Findings& findings, ResultVerdict& verdict)
{
  for (const Finding& finding : findings) verdict.warnings.push_back(finding.kind);
  verdict.status = verdict.warnings.empty() ? ResultStatus::Fine : ResultStatus::Doubtful;
}

std::vector<TargetMotion> targetMotionsOf(const std::vector<WholeMotion>& motions)
{
  std::vector<TargetMotion> result;
  result.reserve(motions.size());
  for (const WholeMotion& whole : motions) result.push_back(whole.motion);
  return result;
}

}  // namespace holdfast
