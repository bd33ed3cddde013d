#include "holdfast/deform/messages.h"

#include <algorithm>

#include <fmt/format.h>

#include <holdfast/base/printable.h>

namespace holdfast {
namespace {

std::size_t countOf(const Report& report, ConstraintStatus status)
{
  return static_cast<std::size_t>(std::count_if(report.constraints.begin(), report.constraints.end(),
                                                [&](const auto& c) { return c.status == status; }));
}

/// By how much it is missed, and what is promised.
std::string missText(const Report& report, const MissedRow& row)
{
  return fmt::format("{} is missed by {:.3g}, more than the promised {:.3g}",
                     inQuotes(report.constraints[row.constraint].name), row.residual, row.limit);
}

std::string accuracyText(double accuracy)
{
  return fmt::format("accuracy {:.2g}", accuracy);
}

}  // namespace

std::string undefinedRowsMessage(const Model& model, const Operators& operators)
{
  return fmt::format(
      "the weights \"{}\" are not finite at {} vertices, the first of them vertex {}, because a face there has no "
      "area; "
      "use the weights \"cotangent\", which are guarded against that, or repair those faces",
      name(operators.weights), operators.undefinedRows.size(),
      model.solverMesh.weld.firstVertexOf[operators.undefinedRows.front()]);
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
  const SolverKind kind = report.solve.options.kind;
  const std::size_t count = report.constraints.size();
  const std::size_t conflicting = countOf(report, ConstraintStatus::Conflicting);
  const std::size_t missed = countOf(report, ConstraintStatus::Missed);
  const std::string by = worst ? fmt::format(" ({})", missText(report, *worst)) : "";
  const std::string accuracy = "; " + accuracyText(report.solve.accuracy);
  if (kind == SolverKind::Soft && conflicting > 0)
    return fmt::format(
               "a compromise: {} of {} constraints conflict with earlier ones, and soft constraints pull towards all "
               "of them at once; {} others are missed as well{}; the solver \"hard\" keeps the earlier ones exactly",
               conflicting, count, missed, by) +
           accuracy;
  const std::string leftOut = fmt::format(
      "{} of {} constraints conflict with earlier ones and were left out where they do; ", conflicting, count);
  const std::string nearly =
      fmt::format("{} of {} constraints are met only approximately{}, as is the nature of the {} solver", missed, count,
                  by, name(kind));
  const std::string all = conflicting > 0 ? "all others are met" : "all constraints are met";
  return (conflicting > 0 ? leftOut : "") + (missed > 0 ? nearly : all) + accuracy;
}

std::string missedMessage(const Report& report, const MissedRow& row)
{
  const double sensitivity = report.constraints[row.constraint].sensitivity.value_or(0);
  if (sensitivity > kLargeSensitivity)
    return fmt::format(
        "{}: constraints beside it nearly repeat it, so that small differences of what they ask for move the mesh far "
        "(amplification {:.2g}); leave one of them out, or move them apart",
        missText(report, row), sensitivity);
  return fmt::format(
      "{}; the cause is not known (amplification of the constraint {:.2g}, {} of the solution); it may help to leave "
      "it out, or those that hold its vertices, or to ask for less far a move",
      missText(report, row), sensitivity, accuracyText(report.solve.accuracy));
}

}  // namespace holdfast
