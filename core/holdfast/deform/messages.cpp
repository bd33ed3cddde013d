#include "holdfast/deform/messages.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/mesh/labels.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

/// A vertex of each part that stays at rest.
std::vector<Index> partsAtRest(const Model& model, const EliminatedByAxes& eliminated)
{
  const std::vector<bool> isHeld = eliminated.isHeld();
  std::vector<Index> atRest(static_cast<std::size_t>(model.solverMesh.componentCount), -1);
  for (Index u = 0; u < model.solverMesh.unknownCount(); ++u)
    if (const Index c = model.solverMesh.componentOf[u]; c >= 0 && isHeld[u] && atRest[c] < 0)
      atRest[c] = model.solverMesh.weld.firstVertexOf[u];
  std::erase(atRest, -1);
  return atRest;
}

Finding nearlyDependent(std::vector<Index> spread, double largest)
{
  const std::string amount =
      fmt::format("where targets disagree by one unit, vertices move by up to {:.2g}; ", largest);
  return makeFinding(
      "nearly_dependent_constraints", "constraint", std::move(spread),
      {"constraint nearly follows from others: " + amount + "move its points apart, or leave it out",
       "constraints nearly follow from others: " + amount + "move their points apart, or leave some out"});
}

/// The constraints of the dependent rows for which `isMeant(dependency)` holds, ascending.
template <class Predicate>
std::vector<Index> constraintsOf(const DeformDetails& details, const Predicate& isMeant)
{
  std::vector<Index> result;
  for (const DependentRow& row : details.diagnosis.dependent)
    if (isMeant(row.dependency)) result.push_back(details.system.rows[row.dependency.row].constraint);
  return sortedOnce(std::move(result));
}

/// Tells whether rows behind it stand in its place, though doubles tell them apart well.
bool gaveWay(const Dependency& dependency)
{
  return !dependency.isUndecided() && !dependency.terms.empty() && dependency.terms.back().index > dependency.row;
}

Finding undecided(std::vector<Index> constraints)
{
  const std::string what =
      ", so closely that it could not be held with them; its rows were left out: move its point, or leave it out";
  return makeFinding("undecided_constraints", "constraint", std::move(constraints),
                     {"constraint nearly follows from constraints before it" + what,
                      "constraints nearly follow from constraints before them, so closely that they could not be held "
                      "with them; their rows were left out: move their points, or leave some out"});
}

Finding laterStand(std::vector<Index> constraints)
{
  const std::string why =
      ": the order of the list takes more digits than doubles have; list the points in a random order to have their "
      "order kept";
  return makeFinding("later_constraints_stand", "constraint", std::move(constraints),
                     {"constraint has lower precedence than constraints behind it" + why,
                      "constraints have lower precedence than constraints behind them" + why});
}

// Fewer are named one by one, and may be mended so.
constexpr Index kCrowd = 100;

Finding crowded(std::vector<Index> constraints)
{
  const std::string what =
      " contradict constraints before them: there are more of them than the vertices that they name can follow; give "
      "fewer points, or let the solver \"soft\" share their errors out";
  return makeFinding("crowded_constraints", "constraint", std::move(constraints),
                     {"constraint" + what, "constraints" + what});
}

/// The residual of a row and its limit.
std::string missText(const Report& report, const MissedRow& row)
{
  return fmt::format("{} is missed by {:.3g}, more than its limit {:.3g}",
                     inQuotes(report.constraints[row.constraint].name), row.residual, row.limit);
}

std::string accuracyText(double accuracy)
{
  return fmt::format("accuracy {:.2g}", accuracy);
}

bool isDoubtful(double accuracy)
{
  return accuracy > kDoubtfulAccuracy && accuracy <= kUsableAccuracy;
}

/// The row that loses most, why, and what to do.
std::string lossText(const DeformDetails& details, const DeterminedPart& part)
{
  const Index constraint = details.system.rows[part.row].constraint;
  return fmt::format(
      "{} nearly follows from other constraints, which multiplies rounding (amplification {:.2g}); leave one of them "
      "out, or move their points apart",
      inQuotes((*details.labels)[constraint].name), (*details.sensitivities)[part.row]);
}

}  // namespace

std::string accuracyFailure(double accuracy)
{
  if (accuracy <= kUsableAccuracy) return "";
  return fmt::format(
      "it is accurate to {:.1g} only, and {:g} is needed: the problem is nearly singular; hold more places, or repair "
      "thin triangles",
      accuracy, kUsableAccuracy);
}

std::optional<Finding> accuracyWarning(const std::string& kind, const std::string& what, double accuracy)
{
  if (!isDoubtful(accuracy)) return std::nullopt;
  return Finding{kind,
                 1,
                 "solution",
                 {},
                 fmt::format("{} is accurate to {:.2g} only where constraints leave it free: the problem is nearly "
                             "singular; hold more places, or repair thin triangles",
                             what, accuracy)};
}

std::string determinedFailure(const DeformDetails& details, const DeterminedPart& part)
{
  if (part.accuracy <= kUsableAccuracy) return "";
  return fmt::format("it is accurate to {:.1g} only, and {:g} is needed: {}", part.accuracy, kUsableAccuracy,
                     lossText(details, part));
}

std::optional<Finding> determinedWarning(const DeformDetails& details, const DeterminedPart& part)
{
  if (!isDoubtful(part.accuracy)) return std::nullopt;
  return Finding{"low_accuracy",
                 1,
                 "solution",
                 {},
                 fmt::format("the solution is accurate to {:.2g} only: {}", part.accuracy, lossText(details, part))};
}

Finding unconvergedWarning(const RotationIterations& iterations, const RotationOptions& options)
{
  return {"rotations_not_converged",
          1,
          "solution",
          {},
          fmt::format("rotations still change after {} iterations: the last one moved a vertex by {:.2g} of the {}, "
                      "and {:g} is asked for; constraints hold all the same; ask for a larger "
                      "\"rotation_change\", or for a smaller move",
                      iterations.count, iterations.change, sizeName(options.source), options.change)};
}

std::string undefinedRowsMessage(const Model& model, const Operators& operators)
{
  return fmt::format(
      "the weights \"{}\" are not finite at {} vertices, the first of them {}, because a face there has no "
      "area; use the weights \"cotangent\", which are guarded against that, or repair those faces",
      name(operators.weights), operators.undefinedRows.size(),
      vertexText(model.mesh, model.solverMesh.weld.firstVertexOf[operators.undefinedRows.front()]));
}

std::string failureMessage(const DeformOptions& options, const std::string& reason)
{
  std::string remedy;
  if (options.weights != Weights::Cotangent)
    remedy = "; the default weights \"cotangent\" are guarded against bad triangles";
  if (options.solver.kind != SolverKind::Hard) remedy += "; the solver \"hard\" is better conditioned";
  return reason + remedy;
}

std::string solvedMessage(const Report& report, const std::optional<MissedRow>& worst)
{
  const std::string accuracy = "; " + accuracyText(report.solve.accuracy);
  const bool hasConflicts = report.solve.status == SolveStatus::Conflicts;
  if (!hasConflicts && !worst) return "all constraints are met" + accuracy;
  const SolverKind kind = report.solve.options.kind;
  const std::size_t count = report.constraints.size();
  const Index conflicting = hasConflicts ? countOf(report, ConstraintStatus::Conflicting) : 0;
  const Index missed = worst ? countOf(report, ConstraintStatus::Missed) : 0;
  const std::string by = worst ? fmt::format(" ({})", missText(report, *worst)) : "";
  if (kind == SolverKind::Soft && conflicting > 0)
    return fmt::format(
               "a compromise: {} of {} constraints conflict with earlier ones, and soft constraints pull towards all "
               "of them at once; {} others are missed as well{}; the solver \"hard\" keeps the earlier ones exactly",
               conflicting, count, missed, by) +
           accuracy;
  const std::string leftOut = fmt::format(
      "{} of {} constraints conflict with earlier ones and were left out where they do; ", conflicting, count);
  const std::string nearly = fmt::format(
      "{} of {} constraints are met only approximately{}; the solver \"hard\" meets them exactly", missed, count, by);
  const std::string all = conflicting > 0 ? "all others are met" : "all constraints are met";
  return (conflicting > 0 ? leftOut : "") + (missed > 0 ? nearly : all) + accuracy;
}

std::string missedMessage(const Report& report, const MissedRow& row)
{
  const double sensitivity = report.constraints[row.constraint].sensitivity.value_or(0);
  if (sensitivity > kLargeSensitivity)
    return fmt::format(
        "{}: other constraints nearly repeat it, and small differences between their targets move the mesh far "
        "(amplification {:.2g}); leave one of them out, or move them apart",
        missText(report, row), sensitivity);
  return fmt::format(
      "{}; the cause is not known (amplification of the constraint {:.2g}, {} of the solution); it may help to leave "
      "it out, or those that hold its vertices, or to ask for a smaller move",
      missText(report, row), sensitivity, accuracyText(report.solve.accuracy));
}

std::vector<Finding> constraintFindings(const Model& model, const EliminatedByAxes& eliminated,
                                        const DeformDetails& details)
{
  std::vector<Finding> findings;
  if (std::vector<Index> atRest = partsAtRest(model, eliminated); !atRest.empty())
    findings.push_back(
        makeFinding("parts_at_rest", "vertex", std::move(atRest),
                    {"connected part that no constraint places; it stays at rest (a vertex of it is named)",
                     "connected parts that no constraint places; they stay at rest (a vertex of each is named)"}));
  const auto largest = std::ranges::max_element(*details.sensitivities);
  if (largest != details.sensitivities->end() && *largest > kLargeSensitivity) {
    const std::vector<std::optional<double>> ofConstraints = constraintSensitivities(details);
    std::vector<Index> spread;
    for (std::size_t c = 0; c < ofConstraints.size(); ++c)
      if (ofConstraints[c].value_or(0) > kLargeSensitivity) spread.push_back(static_cast<Index>(c));
    findings.push_back(nearlyDependent(std::move(spread), *largest));
  }
  if (std::vector<Index> left = constraintsOf(details, std::mem_fn(&Dependency::isUndecided)); !left.empty())
    findings.push_back(undecided(std::move(left)));
  if (std::vector<Index> behind = constraintsOf(details, gaveWay); !behind.empty())
    findings.push_back(laterStand(std::move(behind)));
  for (const ConstraintNote& note : details.system.notes) findings.push_back(noteFinding(note, *details.labels));
  return findings;
}

Finding noteFinding(const ConstraintNote& note, const ConstraintLabels& labels)
{
  return {note.kind,
          1,
          "constraint",
          {note.constraint},
          fmt::format("{} {}", inQuotes(labels[note.constraint].name), note.message)};
}

std::optional<Finding> crowdedFinding(const DeformDetails& details)
{
  std::vector<Index> many = constraintsOf(details, [&](const Dependency& dependency) {
    return details.diagnosis.status[dependency.row] == RowStatus::Conflicting;
  });
  if (static_cast<Index>(many.size()) <= kCrowd) return std::nullopt;
  return crowded(std::move(many));
}

}  // namespace holdfast
