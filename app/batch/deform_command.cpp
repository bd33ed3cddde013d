#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include <holdfast/base/printable.h>
#include <holdfast/base/progress.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/fields.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/report_json.h>
#include <holdfast/io/files/output_file.h>

#include "batch/commands.h"
#include "batch/mesh_formats.h"
#include "batch/outputs.h"
#include "batch/pictures.h"
#include "batch/standard_streams.h"
#include "batch/summary.h"

namespace holdfast::batch {
namespace {

/// Prints nothing in the first second; then the current step and each one that follows, with the seconds since the
/// start.
class ProgressLine final : public Progress {
 public:
  ProgressLine() : thread_([this] { waitAndPrint(); }) {}
  ~ProgressLine() override
  {
    {
      const std::lock_guard lock(mutex_);
      isDone_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  void step(std::string_view description) override
  {
    const std::lock_guard lock(mutex_);
    description_ = description;
    if (isLong_) print();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void waitAndPrint()
  {
    std::unique_lock lock(mutex_);
    if (changed_.wait_until(lock, start_ + std::chrono::seconds(1), [this] { return isDone_; })) return;
    isLong_ = true;
    if (!description_.empty()) print();
  }

  void print() const
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    printMessage(fmt::format("[{:6.1f} s] {}\n", seconds, description_));
  }

  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string description_;
  bool isLong_ = false;
  bool isDone_ = false;
  std::thread thread_;
};

/// Fails before the long work if an output could not be put in its folder.
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

/// Adds a file, and prints what it could not hold.
void addNoted(Outputs& outputs, const std::filesystem::path& path, const Serialized& contents)
{
  for (const std::string& note : contents.notes)
    printMessage(fmt::format("note: {}: {}\n", printable(path.string()), note));
  outputs.add(path, contents.bytes);
}

/// The options of the command line; what it leaves out comes from the session, else from the defaults.
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
  printMessage(messageLines(report, constraints.units));
  if (!command.isQuiet)
    printResult(summary(report, command.mesh.string(), constraints.units) +
                optionsLine(beside(command.options, ofSession), command.constraints.string()));
  outputs.commitAside();
  if (!command.isQuiet)
    for (const OutputFile& file : outputs.files())
      printResult(fmt::format("wrote        {}\n", printable(file.path().string())));
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
