#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/check/mesh_check.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_json.h>

#include "batch/commands.h"
#include "batch/outputs.h"
#include "batch/standard_streams.h"
#include "batch/summary.h"

namespace holdfast::batch {
namespace {

/// Writes the report aside, if there is to be one.
Outputs writeReport(const Command& command, const Report& report)
{
  Outputs outputs;
  if (!command.report.empty()) outputs.add(command.report, reportToJson(report));
  return outputs;
}

/// Nothing more can be said about such a mesh: writes the report, then throws.
void refuseNonFinite(const Command& command, const Mesh& mesh)
{
  Report report;
  report.mesh.findings = findNonFinite(mesh);
  if (report.mesh.findings.empty()) return;
  report.mesh.vertices = mesh.vertexCount();
  report.mesh.faces = mesh.faces.size();
  Outputs outputs = writeReport(command, report);
  outputs.commitDirect();
  outputs.commitAside();
  const Finding& finding = report.mesh.findings.front();
  throw InputError({command.mesh, 0, fmt::format("vertex {}", finding.ids.front())}, finding.message);
}

}  // namespace

ExitCode runCheck(const Command& command)
{
  const MeshDocument document = readMeshFile(command.mesh);
  refuseNonFinite(command, document.mesh);
  const Model model = makeModel(document.mesh, command.mesh);
  const bool hasConstraints = !command.constraints.empty();
  const auto [constraints, ofSession] =
      hasConstraints ? readStatedConstraints(command.constraints) : StatedConstraints{};
  Report report;
  if (hasConstraints)
    report = diagnoseConstraints(model, constraints, command.constraints,
                                 withStated(withStated({}, ofSession), command.options));
  else
    report.mesh = describeMesh(model);

  Outputs outputs = writeReport(command, report);
  outputs.commitDirect();
  printMessage(messageLines(report, constraints.units));
  if (!command.isQuiet) printResult(summary(report, command.mesh, constraints.units));
  outputs.commitAside();
  if (report.solve.status == SolveStatus::Failed) return kNumerical;
  return countOf(report, ConstraintStatus::Conflicting) > 0 ? kConflicts : kAllMet;
}

}  // namespace holdfast::batch
