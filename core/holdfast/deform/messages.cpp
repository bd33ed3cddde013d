#include <algorithm>

#include <fmt/format.h>

#include <holdfast/deform/messages.h>

namespace holdfast {

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
  const auto conflicting = std::count_if(report.constraints.begin(), report.constraints.end(),
                                         [](const auto& c) { return c.status == ConstraintStatus::Conflicting; });
  const auto missed = std::count_if(report.constraints.begin(), report.constraints.end(),
                                    [](const auto& c) { return c.status == ConstraintStatus::Missed; });
  if (missed > 0 && conflicting > 0)
    return fmt::format(
        "a compromise: {} of {} constraints conflict with earlier ones, and the {} solver meets neither them nor {} "
        "others, but only comes near all (beyond {:.3g})",
        conflicting, report.constraints.size(), name(report.solve.options.kind), missed, limit);
  if (missed > 0)
    return fmt::format(
        "{} of {} constraints are met only approximately (beyond {:.3g}), as is the nature of the {} solver", missed,
        report.constraints.size(), limit, name(report.solve.options.kind));
  if (conflicting > 0)
    return fmt::format(
        "{} of {} constraints conflict with earlier ones and were left out where they do; all others are met",
        conflicting, report.constraints.size());
  return "all constraints are met";
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
