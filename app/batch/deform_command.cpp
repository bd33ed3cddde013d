#include <fmt/format.h>

#include <holdfast/base/printable.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/files/output_file.h>

#include "batch/commands.h"
#include "batch/mesh_formats.h"
#include "batch/outputs.h"
#include "batch/pictures.h"
#include "batch/progress_line.h"
#include "batch/standard_streams.h"
#include "batch/summary.h"

namespace holdfast::batch {
namespace {

/// Fails before the long work where an output could not be put in its folder.
void probeOutputs(const DeformCommand& command)
{
  for (const auto& path : {command.out, command.report, command.fields})
    if (path) static_cast<void>(OutputFile(*path, ""));
  if (!command.picture) return;
  static_cast<void>(OutputFile(command.picture->path, ""));
  requirePictures(*command.picture);
}

/// The residuals of what a reader of the written mesh will find: positions rounded to floats.
void measureRounded(DeformResult& deformation, const Model& model)
{
  const Positions stored = deformation.positions.cast<float>().cast<double>();
  const bool isMissed = setResiduals(deformation.report, deformation.details->system, deformation.details->diagnosis,
                                     rowResiduals(deformation.details->system, model.solverMesh.weld, stored))
                            .has_value();
  SolveReport& solve = deformation.report.solve;
  if (isMissed)
    solve.message +=
        fmt::format("; the file holds single precision and misses them by up to {:.3g}", solve.maxResidual);
}

/// Adds a file, and tells what it could not hold.
void addNoted(Outputs& outputs, const std::filesystem::path& path, const Serialized& contents)
{
  for (const std::string& note : contents.notes)
    printMessage(fmt::format("note: {}: {}\n", printable(path.string()), note));
  outputs.add(path, contents.bytes);
}

/// The options of the command line, those of the session where it says nothing, then the defaults.
DeformOptions chosenOptions(const DeformCommand& command, const StatedOptions& ofSession)
{
  const DeformOptions options = withStated(withStated({}, ofSession), command.options);
  if (command.picture && command.picture->colorBy == "force" && options.solver.kind != SolverKind::Hard)
    throw UsageError("--color-by: forces are known with --solver hard only; choose another colouring or that solver");
  return options;
}

/// Writes everything aside.
Outputs writeAll(const DeformCommand& command, const MeshDocument& document, const std::string& units,
                 const Model& model, DeformResult& deformation, Progress& progress)
{
  Outputs outputs;
  const bool isSolved = deformation.report.solve.status != SolveStatus::Failed;
  if (isSolved && command.out) {
    progress.step("writing the mesh");
    const Serialized contents = serializeAnyMesh(document, deformation.positions, *command.out);
    if (contents.isSinglePrecision) measureRounded(deformation, model);
    addNoted(outputs, *command.out, contents);
  }
  if (isSolved && command.fields) {
    progress.step("writing fields");
    addNoted(outputs, *command.fields,
             serializeFields(model.mesh, deformation.positions, fieldsOf(model, deformation)));
  }
  if (isSolved && command.picture) {
    progress.step("drawing the picture");
    outputs.add(command.picture->path, snapshot(*command.picture, model, deformation, units));
  }
  if (command.report) outputs.add(*command.report, reportToJson(deformation.report));
  return outputs;
}

ExitCode exitCodeOf(SolveStatus status)
{
  switch (status) {
    case SolveStatus::Ok:
      return kAllMet;
    case SolveStatus::Conflicts:
      return kConflicts;
    case SolveStatus::Failed:
      return kNumerical;
    case SolveStatus::NotRun:
      break;
  }
  return kBug;
}

ExitCode deformWith(const DeformCommand& command, Progress& progress)
{
  const auto [constraints, ofSession] = readStatedConstraints(command.constraints);
  const DeformOptions options = chosenOptions(command, ofSession);
  probeOutputs(command);
  progress.step(fmt::format("reading {}", printable(command.mesh.string())));
  const MeshDocument document = readAnyMesh(command.mesh);
  progress.step(fmt::format("checking {} vertices", document.mesh.vertexCount()));
  const Model model = makeModel(document.mesh, command.mesh.string());
  DeformResult deformation = deform(model, constraints, command.constraints.string(), options, progress);
  Outputs outputs = writeAll(command, document, constraints.units, model, deformation, progress);

  const Report& report = deformation.report;
  outputs.commitDirect();
  printMessage(warningLines(report));
  printMessage(conflictLines(report, constraints.units));
  if (report.solve.status == SolveStatus::Failed)
    printMessage(fmt::format("error: {}\n", printable(report.solve.message)));
  if (!command.isQuiet)
    printResult(summary(report, command.mesh.string(), constraints.units) +
                optionsLine(beside(command.options, ofSession), command.constraints.string()));
  outputs.commitAside();
  if (!command.isQuiet) printResult(outputs.names());
  return exitCodeOf(report.solve.status);
}

}  // namespace

ExitCode runDeform(const DeformCommand& command)
{
  if (command.isQuiet) {
    NoProgress quiet;
    return deformWith(command, quiet);
  }
  ProgressLine progress;
  return deformWith(command, progress);
}

}  // namespace holdfast::batch
