#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include <holdfast/base/printable.h>
#include <holdfast/base/progress.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/files/output_file.h>

#include "batch/commands.h"
#include "batch/outputs.h"
#include "batch/standard_streams.h"
#include "batch/summary.h"

namespace holdfast::batch {
namespace {

/// Prints nothing in the first second; then the current step and each one that follows, with the seconds since the
/// start.
class ProgressLine final : public Progress {
 public:
  void step(std::string_view description) override
  {
    const std::lock_guard lock(mutex_);
    description_ = description;
    if (isLong_) print();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void waitAndPrint(const std::stop_token& stop)
  {
    std::unique_lock lock(mutex_);
    std::condition_variable_any().wait_until(lock, stop, start_ + std::chrono::seconds(1), [] { return false; });
    isLong_ = !stop.stop_requested();
    if (isLong_ && !description_.empty()) print();
  }

  void print() const
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    printMessage(fmt::format("[{:6.1f} s] {}\n", seconds, description_));
  }

  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::string description_;
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

/// The residuals that the written mesh has: its positions are rounded to floats.
void measureRounded(DeformResult& deformation, const Model& model)
{
  SolveReport& solve = deformation.report.solve;
  if (setRoundedResiduals(deformation.report, deformation, model.solverMesh.weld))
    solve.message +=
        fmt::format("; the file holds single precision and misses them by up to {:.3g}", solve.maxResidual);
}

/// Adds a file, and prints what it could not hold.
void addNoted(Outputs& outputs, const std::string& path, const Serialized& contents)
{
  for (const std::string& note : contents.notes) printMessage(fmt::format("note: {}: {}\n", printable(path), note));
  outputs.add(path, contents.bytes);
}

/// The options of the command line; what it leaves out comes from the session, else from the defaults.
DeformOptions chosenOptions(const Command& command, const StatedOptions& ofSession)
{
  const DeformOptions options = withStated(withStated({}, ofSession), command.options);
  if (!command.picture.path.empty() && command.picture.colorBy == "force" && options.solver.kind != SolverKind::Hard)
    throw UsageError("--color-by: forces are known with --solver hard only; choose another colouring or that solver");
  return options;
}

/// Writes everything aside.
Outputs writeAll(const Command& command, const MeshDocument& document, const std::string& units, const Model& model,
                 DeformResult& deformation, Progress& progress)
{
  Outputs outputs;
  const bool isSolved = deformation.report.solve.status != SolveStatus::Failed;
  if (isSolved && !command.out.empty()) {
    progress.step("writing the mesh");
    const Serialized contents = serializeMeshFile(document, deformation.positions, command.out);
    if (contents.isSinglePrecision) measureRounded(deformation, model);
    addNoted(outputs, command.out, contents);
  }
  if (isSolved && !command.fields.empty()) {
    progress.step("writing fields");
    addNoted(outputs, command.fields, serializeFields(model.mesh, deformation.positions, fieldsOf(model, deformation)));
  }
  if (isSolved && !command.picture.path.empty()) {
    progress.step("drawing the picture");
    outputs.add(command.picture.path, snapshot(command.picture, model, deformation, units));
  }
  if (!command.report.empty()) outputs.add(command.report, reportToJson(deformation.report));
  return outputs;
}

ExitCode deformWith(const Command& command, Progress& progress)
{
  const auto [constraints, ofSession] = readStatedConstraints(command.constraints);
  const DeformOptions options = chosenOptions(command, ofSession);
  probeOutputs(command);
  progress.step(fmt::format("reading {}", printable(command.mesh)));
  const MeshDocument document = readMeshFile(command.mesh);
  progress.step(fmt::format("checking {} vertices", document.mesh.vertexCount()));
  const Model model = makeModel(document.mesh, command.mesh);
  DeformResult deformation = deform(model, constraints, command.constraints, options, progress);
  Outputs outputs = writeAll(command, document, constraints.units, model, deformation, progress);

  const Report& report = deformation.report;
  outputs.commitDirect();
  printMessage(messageLines(report, constraints.units));
  if (!command.isQuiet)
    printResult(summary(report, command.mesh, constraints.units) +
                optionsLine(beside(command.options, ofSession), command.constraints));
  outputs.commitAside();
  if (!command.isQuiet)
    for (const OutputFile& file : outputs.files())
      printResult(fmt::format("wrote        {}\n", printable(file.path().string())));
  if (report.solve.status == SolveStatus::Failed) return kNumerical;
  return report.solve.status == SolveStatus::Conflicts ? kConflicts : kAllMet;
}

}  // namespace

ExitCode runDeform(const Command& command)
{
  if (command.isQuiet) {
    NoProgress quiet;
    return deformWith(command, quiet);
  }
  ProgressLine progress;
  return deformWith(command, progress);
}

}  // namespace holdfast::batch
