#include "batch/summary.h"

#include <algorithm>

#include <fmt/format.h>

namespace holdfast::batch {
namespace {

std::string withUnits(double length, const std::string& units)
{
  return fmt::format("{:.4g}{}{}", length, units.empty() ? "" : " ", units);
}

std::string quotedNames(const std::vector<std::string>& names)
{
  constexpr std::size_t kMostNames = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), kMostNames); ++k)
    text += fmt::format("{}\"{}\"", k == 0 ? "" : ", ", names[k]);
  if (names.size() > kMostNames) text += fmt::format(" and {} more", names.size() - kMostNames);
  return text;
}

std::string countOf(const Report& report, ConstraintStatus status)
{
  const auto count = std::count_if(report.constraints.begin(), report.constraints.end(),
                                   [&](const ConstraintOutcome& outcome) { return outcome.status == status; });
  return count == 0 ? "" : fmt::format(", {} {}", count, name(status));
}

std::string constraintLine(const Report& report)
{
  Index rows = 0;
  for (const ConstraintOutcome& outcome : report.constraints) rows += outcome.rows;
  std::string line = fmt::format("constraints  {} in {} rows", report.constraints.size(), rows);
  for (const ConstraintStatus status :
       {ConstraintStatus::Independent, ConstraintStatus::Met, ConstraintStatus::Redundant,
        ConstraintStatus::Conflicting, ConstraintStatus::Missed, ConstraintStatus::Disabled})
    line += countOf(report, status);
  return line + "\n";
}

std::string solveLines(const SolveReport& solve, const std::string& units)
{
  std::string lines = fmt::format("solve        {}: {}\n", name(solve.status), solve.message);
  if (solve.status != SolveStatus::Ok && solve.status != SolveStatus::Conflicts) return lines;
  lines += fmt::format("residual     largest {}, {:.2g} of the bounding box's diagonal\n",
                       withUnits(solve.maxResidual, units), solve.maxResidualRelative);
  lines += fmt::format("method       {} weights, {} solver, {}; {} unknowns, {} non-zeros, {} corrections\n",
                       name(solve.weights), name(solve.options.kind), solve.method, solve.unknowns,
                       solve.factorNonzeros, solve.refinementSteps);
  lines += fmt::format("seconds      set-up {:.3f}, decomposition {:.3f}, solution {:.3f}\n", solve.seconds.setup,
                       solve.seconds.decomposition, solve.seconds.solution);
  return lines;
}

}  // namespace

std::string summary(const Report& report, const std::string& meshName, const std::string& units)
{
  std::string text = fmt::format("mesh         {}: {} vertices, {} faces, {} connected part{}, diagonal {}\n", meshName,
                                 report.mesh.vertices, report.mesh.faces, report.mesh.components,
                                 report.mesh.components == 1 ? "" : "s", withUnits(report.mesh.bboxDiagonal, units));
  for (const Finding& finding : report.mesh.findings) text += fmt::format("  finding    {}\n", finding.message);
  if (!report.constraints.empty()) text += constraintLine(report);
  if (report.solve.status != SolveStatus::NotRun) text += solveLines(report.solve, units);
  return text;
}

std::string conflictLines(const Report& report, const std::string& units)
{
  std::string text;
  for (const ConstraintOutcome& outcome : report.constraints)
    if (outcome.status == ConstraintStatus::Conflicting)
      text += fmt::format("conflict: \"{}\" contradicts {} by {}; it is left out where it does\n", outcome.name,
                          quotedNames(outcome.dependsOn), withUnits(outcome.gap.value_or(0), units));
  return text;
}

}  // namespace holdfast::batch
