#include "holdfast/deform/messages.h"

#include <algorithm>

#include <fmt/format.h>

namespace holdfast {
namespace {

std::size_t countOf(const Report& report, ConstraintStatus status)
{
  return static_cast<std::size_t>(std::count_if(report.constraints.begin(), report.constraints.end(),
                                                [&](const auto& c) { return c.status == status; }));
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

std::string solvedMessage(const Report& report, double limit)
{
  const SolverKind kind = report.solve.options.kind;
  const std::size_t count = report.constraints.size();
  const std::size_t conflicting = countOf(report, ConstraintStatus::Conflicting);
  const std::size_t missed = countOf(report, ConstraintStatus::Missed);
  if (kind == SolverKind::Soft && conflicting > 0)
    return fmt::format(
        "a compromise: {} of {} constraints conflict with earlier ones, and soft constraints pull towards all of them "
        "at once; {} others are missed as well (beyond {:.3g}); the solver \"hard\" keeps the earlier ones exactly",
        conflicting, count, missed, limit);
  const std::string leftOut = fmt::format(
      "{} of {} constraints conflict with earlier ones and were left out where they do; ", conflicting, count);
  const std::string nearly =
      fmt::format("{} of {} constraints are met only approximately (beyond {:.3g}), as is the nature of the {} solver",
                  missed, count, limit, name(kind));
  const std::string all = conflicting > 0 ? "all others are met" : "all constraints are met";
  return (conflicting > 0 ? leftOut : "") + (missed > 0 ? nearly : all);
}

std::string missedMessage(const Report& report, double limit)
{
  const auto worst = std::find_if(report.constraints.begin(), report.constraints.end(), [&](const auto& outcome) {
    return outcome.status == ConstraintStatus::Missed && outcome.residual == report.solve.maxResidual;
  });
  const std::string name = worst == report.constraints.end() ? "a constraint" : '"' + worst->name + '"';
  return fmt::format(
      "{} is missed by {:.3g}, more than the promised {:.3g}, because constraints beside it nearly repeat it and ask "
      "for something else; leave one of them out, or move them apart",
      name, report.solve.maxResidual, limit);
}

}  // namespace holdfast
