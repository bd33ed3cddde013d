#include <algorithm>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/check/mesh_check.h>
#include <holdfast/deform/report_json.h>

#include "batch/commands.h"
#include "batch/mesh_formats.h"
#include "batch/outputs.h"
#include "batch/standard_streams.h"
#include "batch/summary.h"

namespace holdfast::batch {
namespace {

/// Writes the report aside, if there is to be one.
Outputs writeReport(const CheckCommand& command, const Report& report)
{
  Outputs outputs;
  if (command.report) outputs.add(*command.report, reportToJson(report));
  return outputs;
}

/// Nothing more can be said about such a mesh: writes the report, then throws.
void refuseNonFinite(const CheckCommand& command, const Mesh& mesh)
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
  throw InputError({command.mesh.string(), 0, fmt::format("vertex {}", finding.ids.front())}, finding.message);
}

}  // namespace

ExitCode runCheck(const CheckCommand& command)
{
  const MeshDocument document = readAnyMesh(command.mesh);
  refuseNonFinite(command, document.mesh);
  const Model model = makeModel(document.mesh, command.mesh.string());
  const auto [constraints, ofSession] =
      command.constraints ? readStatedConstraints(*command.constraints) : StatedConstraints{};
  const std::string source = command.constraints ? command.constraints->string() : "";
  Report report;
  if (command.constraints)
    report = diagnoseConstraints(model, constraints, source, withStated(withStated({}, ofSession), command.options));
  else
    report.mesh = describeMesh(model);

  Outputs outputs = writeReport(command, report);
  outputs.commitDirect();
  printMessage(messageLines(report, constraints.units));
  if (!command.isQuiet) printResult(summary(report, command.mesh.string(), constraints.units));
  outputs.commitAside();
  if (report.solve.status == SolveStatus::Failed) return kNumerical;
  const bool hasConflicts =
      std::any_of(report.constraints.begin(), report.constraints.end(),
                  [](const ConstraintOutcome& outcome) { return outcome.status == ConstraintStatus::Conflicting; });
  return hasConflicts ? kConflicts : kAllMet;
}

}  // namespace holdfast::batch
