#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include <holdfast/check/mesh_check.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/field_file.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/mesh/labels.h>
#include <holdfast/threads/progress.h>
#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

#include "batch/batch.h"

namespace holdfast::batch {
namespace {

/// Outputs of one command. All are written aside before any is put in its place.
using Outputs = std::vector<OutputFile>;

/// What cannot be written aside (a device, a pipe) goes first: it may be full, while a rename hardly ever fails.
void commit(Outputs& outputs, bool areDirect)
{
  for (OutputFile& output : outputs)
    if (output.isDirect() == areDirect) output.commit();
}

void addReport(Outputs& outputs, const Command& command, const Report& report)
{
  if (!command.report.empty()) outputs.emplace_back(command.report, reportToJson(report));
}

ExitCode finish(Outputs& outputs, const Command& command, const Report& report, const std::string& units,
                const std::string& options)
{
  commit(outputs, true);
  printMessage(skippedLines(report, command.constraints) + messageLines(report, units));
  if (!command.isQuiet) printResult(summary(report, command.mesh, units) + options);
  commit(outputs, false);
  if (report.solve.status == SolveStatus::Failed) return kNumerical;
  return countOf(report, ConstraintStatus::Conflicting) > 0 ? kConflicts : kAllMet;
}

/// Nothing more can be said about such a mesh: writes the report, then throws.
void refuseNonFinite(const Command& command, const Mesh& mesh)
{
  const Report report{{mesh.vertexCount(), mesh.faces.size(), 0, 0, findNonFinite(mesh)}, {}, {}};
  if (report.mesh.findings.empty()) return;
  Outputs outputs;
  addReport(outputs, command, report);
  for (OutputFile& output : outputs) output.commit();
  const Finding& finding = report.mesh.findings.front();
  throw InputError({command.mesh, 0, vertexText(mesh, finding.ids.front())}, finding.message);
}

/// Prints nothing in the first second; then each step and, of those that take long, every fifth, with the seconds since
/// the start.
class ProgressLine final : public Progress {
 public:
  void step(std::string_view description) override
  {
    const std::lock_guard lock(mutex_);
    description_ = description;
    percent_ = 0;
    if (isLong_) print(description_);
  }
  void proceed(double share) override
  {
    constexpr int kEvery = 20;  // percent
    const std::lock_guard lock(mutex_);
    const auto percent = static_cast<int>(100 * share);
    if (!isLong_ || percent < percent_ + kEvery) return;
    percent_ = percent;
    print(withPercent(description_, percent));
  }

 private:
  using Clock = std::chrono::steady_clock;

  void waitAndPrint(const std::stop_token& stop)
  {
    std::unique_lock lock(mutex_);
    std::condition_variable_any().wait_until(lock, stop, start_ + std::chrono::seconds(1), [] { return false; });
    isLong_ = !stop.stop_requested();
    if (isLong_ && !description_.empty()) print(description_);
  }

  void print(std::string_view text) const
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    printMessage(fmt::format("[{:6.1f} s] {}\n", seconds, text));
  }

  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::string description_;
  int percent_ = 0;  // printed last
  bool isLong_ = false;
  std::jthread thread_{[this](const std::stop_token& stop) { waitAndPrint(stop); }};
};

/// Fails before the long work if an output could not be put in its folder.
void probeOutputs(const Command& command)
{
  for (const std::string& path : {command.out, command.report, command.fields, command.picture.path})
    if (!path.empty()) static_cast<void>(OutputFile(path, ""));
  if (!command.picture.path.empty()) requireDisplay(command.picture);
}

void addNoted(Outputs& outputs, const std::string& path, const Serialized& contents)
{
  for (const std::string& note : contents.notes) printMessage(fmt::format("note: {}: {}\n", printable(path), note));
  outputs.emplace_back(path, contents.bytes);
}

/// The options of the command line; what it leaves out comes from the session, else from the defaults.
DeformOptions chosenOptions(const Command& command, const StatedOptions& ofSession)
{
  const DeformOptions options = withStated(withStated({}, ofSession), command.options);
  if (!command.picture.path.empty() && command.picture.colorBy == "force" && options.solver.kind != SolverKind::Hard)
    throw UsageError("--color-by: forces are known with --solver hard only; choose another colouring or that solver");
  return options;
}

/// Writes everything aside. Residuals become those of the written mesh where its format rounds positions.
Outputs writeAll(const Command& command, const MeshDocument& document, const std::string& units, const Model& model,
                 DeformResult& deformation, Progress& progress)
{
  Outputs outputs;
  SolveReport& solve = deformation.report.solve;
  const bool isSolved = solve.status != SolveStatus::Failed;
  if (isSolved && !command.out.empty()) {
    progress.step("writing the mesh");
    const Serialized contents = serializeMeshFile(document, deformation.positions, command.out);
    const bool isMissed =
        contents.stored && setStoredResiduals(deformation.report, deformation, *contents.stored, model.solverMesh.weld);
    if (isMissed)
      solve.message += fmt::format("; the file rounds coordinates and misses them by up to {:.3g}", solve.maxResidual);
    addNoted(outputs, command.out, contents);
  }
  if (isSolved && !command.fields.empty()) {
    progress.step("writing fields");
    addNoted(outputs, command.fields, fieldsToVtp(model.mesh, deformation.positions, fieldsOf(model, deformation), {}));
  }
  if (isSolved && !command.picture.path.empty()) {
    progress.step("drawing the picture");
    outputs.emplace_back(command.picture.path, snapshot(command.picture, model, deformation, units));
  }
  addReport(outputs, command, deformation.report);
  return outputs;
}

ExitCode deformWith(const Command& command, Progress& progress)
{
  const auto [constraints, ofSession, skippedRows] = readStatedConstraints(command.constraints, command.badRows);
  const DeformOptions options = chosenOptions(command, ofSession);
  probeOutputs(command);
  progress.step(fmt::format("reading {}", printable(command.mesh)));
  const MeshDocument document = readMesh(command.mesh);
  progress.step(fmt::format("checking {} vertices", document.mesh.vertexCount()));
  const Model model = makeModelOfFile(document, command.mesh, options.weldTolerance);
  DeformResult deformation = deform(model, constraints, command.constraints, options, progress);
  deformation.report.skippedRows = skippedRows;
  Outputs outputs = writeAll(command, document, constraints.units, model, deformation, progress);
  const ExitCode code = finish(outputs, command, deformation.report, constraints.units,
                               optionsLine(command.options, ofSession, command.constraints));
  if (!command.isQuiet)
    for (const OutputFile& output : outputs)
      printResult(fmt::format("wrote        {}\n", printable(output.path().string())));
  return code;
}

}  // namespace

ExitCode runCheck(const Command& command)
{
  const MeshDocument document = readMesh(command.mesh);
  refuseNonFinite(command, document.mesh);
  StatedConstraints stated;
  if (!command.constraints.empty()) stated = readStatedConstraints(command.constraints, command.badRows);
  const DeformOptions options = withStated(withStated({}, stated.options), command.options);
  const Model model = makeModelOfFile(document, command.mesh, options.weldTolerance);
  Report report{describeMesh(model), {}, {}};
  if (!command.constraints.empty()) {
    report = diagnoseConstraints(model, stated.list, command.constraints, options);
    report.skippedRows = stated.skippedRows;
  }
  Outputs outputs;
  addReport(outputs, command, report);
  return finish(outputs, command, report, stated.list.units, "");
}

ExitCode runDeform(const Command& command)
{
  if (command.isQuiet) return deformWith(command, noProgress());
  ProgressLine progress;
  return deformWith(command, progress);
}

}  // namespace holdfast::batch
