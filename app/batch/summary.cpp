#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <holdfast/deform/outcomes.h>
#include <holdfast/words/printable.h>

#include "batch/batch.h"

namespace holdfast::batch {
namespace {

constexpr std::size_t kMostPulling = 5;
constexpr std::size_t kMostConflictLines = 5;

// A share of the length of a vector: smaller components are rounding errors.
constexpr double kLeastComponent = 1e-6;

std::string withUnits(double length, const std::string& units)
{
  return fmt::format("{:.4g}{}{}", length, units.empty() ? "" : " ", shortened(units));
}

/// Rounded, to look at.
std::string gapText(const Vector3& gap)
{
  const auto shown = [&](double x) { return std::abs(x) < kLeastComponent * gap.stableNorm() ? 0 : x; };
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", shown(gap.x()), shown(gap.y()), shown(gap.z()));
}

/// The first of `count` names.
std::string quotedNames(const std::vector<std::string>& names, std::size_t count)
{
  constexpr std::size_t kMostNames = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), kMostNames); ++k)
    text.append(k == 0 ? "" : k + 1 == count ? " and " : ", ").append(inQuotes(names[k]));
  if (count > kMostNames) text += fmt::format(" and {} more", count - kMostNames);
  return text;
}

/// The message, with the names of constraints that it is about.
std::string findingText(const Finding& finding, const ConstraintOutcomes& constraints)
{
  std::vector<std::string> names;
  if (finding.idsOf == "constraint")
    for (const Index c : finding.ids) names.push_back(constraints[c].name);
  return fmt::format("{}{}{}", printable(finding.message), names.empty() ? "" : ": ", quotedNames(names, names.size()));
}

/// Tells whether it is about the solution or what that made of the part, or may make the result another one than was
/// meant.
bool isWarning(const Finding& finding, const ResultVerdict& result)
{
  constexpr std::array<std::string_view, 4> kKinds{"places_off_surface", "places_in_one_spot", "places_between_sides",
                                                   "nearly_coincident_vertices"};
  return finding.idsOf == "solution" || std::ranges::count(kKinds, finding.kind) != 0 ||
         std::ranges::count(result.warnings, finding.kind) != 0;
}

std::string constraintLine(const Report& report)
{
  Index rows = 0;
  for (const ConstraintOutcome& outcome : report.constraints) rows += outcome.rows;
  std::string line = fmt::format("constraints  {} in {}", report.constraints.size(), counted(rows, "row"));
  for (const ConstraintStatus status :
       {ConstraintStatus::Independent, ConstraintStatus::Met, ConstraintStatus::Redundant,
        ConstraintStatus::Conflicting, ConstraintStatus::Missed, ConstraintStatus::Disabled})
    if (const Index count = countOf(report, status); count > 0) line += fmt::format(", {} {}", count, name(status));
  return line + "\n";
}

/// How far the places that constraints name by `near` lie off the surface.
std::string placesLine(const ConstraintOutcomes& constraints, const std::string& units)
{
  Index count = 0;
  double farthest = 0;
  for (const ConstraintOutcome& outcome : constraints) {
    if (outcome.nearDistance) ++count;
    farthest = std::max(farthest, outcome.nearDistance.value_or(0));
  }
  if (count == 0) return "";
  return fmt::format("places       {} by \"near\", at most {} from the surface\n", counted(count, "constraint"),
                     withUnits(farthest, units));
}

std::string toleranceLine(const ConstraintOutcomes& constraints, const std::string& units)
{
  Index count = 0;
  Index atBound = 0;
  double farthest = 0;
  for (const ConstraintOutcome& outcome : constraints) {
    if (!outcome.offTarget) continue;
    ++count;
    if (outcome.isAtBound.value_or(false)) ++atBound;
    farthest = std::max(farthest, *outcome.offTarget);
  }
  if (count == 0) return "";
  return fmt::format("tolerances   {} at most {} from their targets, {} at a bound\n", counted(count, "point"),
                     withUnits(farthest, units), atBound);
}

std::string pullLine(const ConstraintOutcomes& constraints)
{
  std::vector<const ConstraintOutcome*> pulling;
  for (const ConstraintOutcome& outcome : constraints)
    if (outcome.multiplier.value_or(0) > 0) pulling.push_back(&outcome);
  if (pulling.empty()) return "";
  std::stable_sort(pulling.begin(), pulling.end(),
                   [](const auto* a, const auto* b) { return a->multiplier > b->multiplier; });
  std::string line = "pull         hardest: ";
  for (std::size_t k = 0; k < std::min(pulling.size(), kMostPulling); ++k)
    line += fmt::format("{}{} {:.3g}", k == 0 ? "" : ", ", inQuotes(pulling[k]->name), *pulling[k]->multiplier);
  return line + "\n";
}

std::string solveLines(const SolveReport& solve, const std::string& units)
{
  std::string lines = fmt::format("solve        {}: {}\n", name(solve.status), printable(solve.message));
  if (solve.status != SolveStatus::Ok && solve.status != SolveStatus::Conflicts) return lines;
  lines += fmt::format("residual     largest {}, {:.2g} of the bounding box's diagonal\n",
                       withUnits(solve.maxResidual, units), solve.maxResidualRelative);
  lines += fmt::format("method       {} weights, {} solver, {}; {}, {}, {}\n", name(solve.weights),
                       name(solve.options.kind), solve.method, counted(solve.unknowns, "unknown"),
                       counted(solve.factorNonzeros, "non-zero"), counted(solve.refinementSteps, "correction"));
  if (solve.iterations)
    lines += fmt::format("rotations    {} in {}, the last of which moved a vertex by {:.2g} of the {}\n",
                         name(solve.rotations), counted(solve.iterations->count, "iteration"), solve.iterations->change,
                         sizeName(solve.rotations));
  lines += fmt::format("seconds      set-up {:.3f}, decomposition {:.3f}, solution {:.3f}\n", solve.seconds.setup,
                       solve.seconds.factorization, solve.seconds.solution);
  return lines;
}

/// Ratios of one kind: "0.98 to 1.2".
std::string rangeText(const RatioVerdict& ratios)
{
  return fmt::format("{:.3g} to {:.3g}", ratios.least, ratios.most);
}

std::string resultLine(const ResultVerdict& result)
{
  if (result.status == ResultStatus::NotMeasured) return "";
  std::vector<std::string> kinds = result.warnings;
  for (std::string& kind : kinds) std::ranges::replace(kind, '_', ' ');
  return fmt::format("result       {}{}{}; edges {} of their lengths, areas {}, volumes {}\n", name(result.status),
                     kinds.empty() ? "" : ": ", fmt::join(kinds, ", "), rangeText(result.edges),
                     rangeText(result.areas), rangeText(result.volumes));
}

std::string repairText(const ConstraintOutcome& outcome, const ConflictSet& conflictSet)
{
  std::string text = fmt::format("disable {}", inQuotes(conflictSet.disable));
  if (conflictSet.consistentTarget) {
    const std::string it = conflictSet.disable == outcome.name ? "it" : inQuotes(outcome.name);
    const char* const what = outcome.type == "relative" ? "offset" : "target";
    const Vector3& place = *conflictSet.consistentTarget;  // with every digit, to copy
    text += fmt::format(", or give {} the {} ({}, {}, {})", it, what, place.x(), place.y(), place.z());
  }
  if (conflictSet.isMetByFoundRotations) text += ", or let rotations be found (--rotations found), which meets it";
  return text;
}

std::string conflictLine(const ConstraintOutcome& outcome, const ConflictSet& conflictSet, const std::string& units)
{
  const std::string partners =
      conflictSet.with.empty()
          ? "on its own"
          : "with " + quotedNames(conflictSet.with, static_cast<std::size_t>(conflictSet.withCount));
  const std::string where =
      outcome.rows > 1 ? fmt::format(" in {} of its {} rows", conflictSet.rows, outcome.rows) : "";
  return fmt::format("conflict: {} cannot hold {}{}: off by {}{} {}; {}\n", inQuotes(outcome.name), partners, where,
                     outcome.rows > 1 ? "up to " : "", withUnits(conflictSet.gap.stableNorm(), units),
                     gapText(conflictSet.gap), repairText(outcome, conflictSet));
}

/// The first few sets with which it conflicts; the largest gaps come first.
std::string conflictLinesOf(const ConstraintOutcome& outcome, const std::string& units)
{
  std::string text;
  std::size_t count = 0;
  for (const ConflictSet& conflictSet : outcome.conflictSets)
    if (conflictSet.isConflict && count++ < kMostConflictLines) text += conflictLine(outcome, conflictSet, units);
  if (count > kMostConflictLines)
    text += fmt::format("conflict: {} cannot hold in {}; the report lists them\n", inQuotes(outcome.name),
                        counted(static_cast<Index>(count - kMostConflictLines), "more way"));
  return text;
}

/// What ends all conflicts at a time: following what each one names may take several rounds.
std::string endOfAllLine(const Report& report)
{
  const Index count = countOf(report, ConstraintStatus::Conflicting);
  if (count < 2) return "";
  return fmt::format("conflict: {} constraints in all; with all of them disabled no conflict is left\n", count);
}

}  // namespace

std::string summary(const Report& report, const std::string& meshName, const std::string& units)
{
  std::string text =
      fmt::format("mesh         {}: {} vertices, {}, {}, diagonal {}\n", printable(meshName), report.mesh.vertices,
                  counted(report.mesh.faces, "face"), counted(report.mesh.components, "connected part"),
                  withUnits(report.mesh.bboxDiagonal, units));
  for (const Finding& finding : report.mesh.findings)
    text += fmt::format("  finding    {}\n", findingText(finding, report.constraints));
  if (!report.constraints.empty()) text += constraintLine(report) + placesLine(report.constraints, units);
  if (!report.skippedRows.empty())
    text += fmt::format("skipped      {} of the point list\n",
                        counted(static_cast<Index>(report.skippedRows.size()), "bad row"));
  if (report.solve.status != SolveStatus::NotRun) text += solveLines(report.solve, units);
  return text + resultLine(report.result) + toleranceLine(report.constraints, units) + pullLine(report.constraints);
}

std::string optionsLine(const StatedOptions& asked, const StatedOptions& session, const std::string& source)
{
  std::vector<std::string> options;
  if (session.weights && !asked.weights) options.push_back(fmt::format("weights {}", name(*session.weights)));
  if (session.solver && !asked.solver) options.push_back(fmt::format("solver {}", name(*session.solver)));
  if (session.softWeight && !asked.softWeight) options.push_back(fmt::format("soft weight {}", *session.softWeight));
  if (session.backend && !asked.backend) options.push_back(fmt::format("backend {}", name(*session.backend)));
  if (session.rotations && !asked.rotations) options.push_back(fmt::format("rotations {}", name(*session.rotations)));
  if (session.rotationChange && !asked.rotationChange)
    options.push_back(fmt::format("rotation change {}", *session.rotationChange));
  if (session.nearLimit && !asked.nearLimit) options.push_back(fmt::format("near limit {}", *session.nearLimit));
  if (session.weldTolerance && !asked.weldTolerance) options.push_back(fmt::format("weld {}", *session.weldTolerance));
  if (options.empty()) return "";
  return fmt::format("options      {}: taken from {}\n", fmt::join(options, ", "), printable(source));
}

std::string skippedLines(const Report& report, const std::string& source)
{
  std::string text;
  for (const SkippedRow& row : report.skippedRows)
    text += fmt::format("warning: {}:{}: {} is skipped: {}\n", printable(source), row.line, inQuotes(row.name),
                        printable(row.fault));
  return text;
}

std::string messageLines(const Report& report, const std::string& units)
{
  std::string text;
  for (const Finding& finding : report.mesh.findings)
    if (isWarning(finding, report.result))
      text += fmt::format("warning: {}\n", findingText(finding, report.constraints));
  for (const ConstraintOutcome& outcome : report.constraints) text += conflictLinesOf(outcome, units);
  text += endOfAllLine(report);
  if (report.solve.status == SolveStatus::Failed) text += fmt::format("error: {}\n", printable(report.solve.message));
  return text;
}

}  // namespace holdfast::batch
