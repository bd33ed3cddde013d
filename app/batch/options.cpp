#include "batch/options.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <holdfast/base/printable.h>
#include <holdfast/version.h>

#include "batch/mesh_formats.h"

namespace holdfast::batch {
namespace {

const std::map<std::string, Weights> kWeights{
    {"cotangent", Weights::Cotangent}, {"cotangent-paper", Weights::CotangentPaper}, {"uniform", Weights::Uniform}};
const std::map<std::string, SolverKind> kSolvers{
    {"hard", SolverKind::Hard}, {"soft", SolverKind::Soft}, {"lagrange", SolverKind::Lagrange}};

std::map<std::string, Backend> backends()
{
  std::map<std::string, Backend> result{{"holdfast", Backend::Holdfast}, {"eigen", Backend::Eigen}};
  if (isBuilt(Backend::Cholmod)) result.emplace("cholmod", Backend::Cholmod);
  return result;
}

/// The value of an option that has a few, or none where it was not given.
template <class Value>
std::optional<Value> chosen(const std::string& option, const std::optional<std::string>& text,
                            const std::map<std::string, Value>& values)
{
  if (!text) return std::nullopt;
  if (const auto found = values.find(*text); found != values.end()) return found->second;
  std::string known;
  for (const auto& [key, value] : values) known += (known.empty() ? "" : ", ") + key;
  throw UsageError(fmt::format("{}: {} is not one of {}", option, inQuotes(*text), known));
}

/// What the command line says, as text.
struct RawOptions {
  std::string mesh;
  std::string constraints;
  std::string out;
  std::string report;
  std::string fields;
  std::string snapshot;
  std::string colorBy = "displacement";
  std::string size = "1280x960";
  std::optional<std::string> weights;
  std::optional<std::string> solver;
  std::optional<std::string> backend;
  std::optional<double> softWeight;
  bool isQuiet = false;
};

void describePictures(CLI::App& deformApp, RawOptions& raw)
{
  CLI::Option* const snapshot =
      deformApp.add_option("--snapshot", raw.snapshot, "Draw the deformed mesh into this file")->type_name("P.png");
  deformApp.add_option("--color-by", raw.colorBy, "Colours of the picture: " + knownColorings())
      ->needs(snapshot)
      ->type_name("FIELD")
      ->capture_default_str();
  deformApp.add_option("--size", raw.size, "Size of the picture in pixels")
      ->needs(snapshot)
      ->type_name("WxH")
      ->capture_default_str();
}

/// An option that a session may state as well.
void addOption(const char* option, auto& value, const std::string& values, const auto& otherwise, CLI::App& command)
{
  command.add_option(option, value, fmt::format("{}; what the session says if left out, else {}", values, otherwise));
}

void describe(CLI::App& app, CLI::App& deformApp, CLI::App& checkApp, RawOptions& raw)
{
  const DeformOptions defaults;
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 all met, 2 usage, 3 unusable input, 4 constraints conflict, 5 numerical failure,\n"
      "6 an output cannot be written, 70 a bug of ours. See docs/errors.md.");
  for (CLI::App* command : {&app, &deformApp, &checkApp}) {
    command->set_version_flag("--version", std::string("holdfast-batch " HOLDFAST_VERSION));
    command->add_flag("--quiet", raw.isQuiet, "Print neither progress nor the summary");
  }
  for (CLI::App* command : {&deformApp, &checkApp}) {
    command->add_option("mesh", raw.mesh, "Mesh file: " + knownFormats())->required()->type_name("MESH");
    command->add_option("--report", raw.report, "Write the report (JSON) here")->type_name("R.json");
    addOption("--weights", raw.weights, "cotangent, cotangent-paper or uniform", name(defaults.weights), *command);
    addOption("--backend", raw.backend, "holdfast, cholmod or eigen", name(defaults.solver.backend), *command);
  }
  checkApp
      .add_option("--constraints", raw.constraints, "Constraint file (JSON), session (.holdfast) or point list (CSV)")
      ->type_name("C.json");
  deformApp
      .add_option("--constraints", raw.constraints, "Constraint file (JSON), session (.holdfast) or point list (CSV)")
      ->required()
      ->type_name("C.json");
  deformApp.add_option("--out", raw.out, "Write the deformed mesh here, in the format of the name")->type_name("MESH");
  deformApp.add_option("--fields", raw.fields, "Write residuals, displacements, rotations and forces on the mesh here")
      ->type_name("F.vtp");
  describePictures(deformApp, raw);
  addOption("--solver", raw.solver, "hard, soft or lagrange", name(defaults.solver.kind), deformApp);
  addOption("--soft-weight", raw.softWeight, "Weight of the constraints of the solver soft", defaults.solver.softWeight,
            deformApp);
}

std::optional<std::filesystem::path> pathOrNone(const std::string& text)
{
  if (text.empty()) return std::nullopt;
  return std::filesystem::path(text);
}

/// The file that writing to `path` makes or replaces. Symbolic links are followed also where they lead to nothing yet.
std::filesystem::path writtenFile(std::filesystem::path path)
{
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, error); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  // A path without a folder is made absolute first: nothing of it need exist, and then it stays relative.
  const std::filesystem::path end = std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  return error ? path : end;
}

/// Whether both names lead to one file, which need not exist. Hard links of one file count as one.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b)
{
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored) || writtenFile(a) == writtenFile(b);
}

struct NamedPath {
  std::string option;
  std::string path;
};

/// No output may take the place of another or of an input.
void checkPaths(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs)
{
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    if (outputs[k].path.empty()) continue;
    std::error_code ignored;
    if (std::filesystem::exists(outputs[k].path, ignored) &&
        !std::filesystem::is_regular_file(outputs[k].path, ignored))
      continue;  // a device or a pipe can take several outputs
    for (const NamedPath& input : inputs)
      if (!input.path.empty() && isSameFile(outputs[k].path, input.path))
        throw UsageError(fmt::format("{} would overwrite the input \"{}\"; choose another name", outputs[k].option,
                                     printable(input.path)));
    for (std::size_t other = 0; other < k; ++other)
      if (!outputs[other].path.empty() && isSameFile(outputs[k].path, outputs[other].path))
        throw UsageError(fmt::format("{} and {} name the same file \"{}\"; choose another name for one of them",
                                     outputs[other].option, outputs[k].option, printable(outputs[k].path)));
  }
}

/// What the names of weights, solver and backend mean.
StatedOptions statedOptions(const RawOptions& raw)
{
  return {chosen("--weights", raw.weights, kWeights), chosen("--solver", raw.solver, kSolvers), raw.softWeight,
          chosen("--backend", raw.backend, backends())};
}

DeformCommand deformCommand(const RawOptions& raw)
{
  checkPaths({{"MESH", raw.mesh}, {"--constraints", raw.constraints}},
             {{"--out", raw.out}, {"--report", raw.report}, {"--fields", raw.fields}, {"--snapshot", raw.snapshot}});
  if (!raw.out.empty()) requireMeshExtension(raw.out);
  if (!raw.fields.empty()) requireFieldsExtension(raw.fields);
  if (raw.softWeight && (!(*raw.softWeight > 0) || !std::isfinite(*raw.softWeight)))
    throw UsageError(fmt::format("--soft-weight: {} is not a positive number", *raw.softWeight));
  const StatedOptions options = statedOptions(raw);
  std::optional<PictureRequest> picture;
  if (!raw.snapshot.empty()) picture = pictureRequest(raw.snapshot, raw.colorBy, raw.size);
  return {raw.mesh, raw.constraints, pathOrNone(raw.out), pathOrNone(raw.report), pathOrNone(raw.fields),
          picture,  options,         raw.isQuiet};
}

CheckCommand checkCommand(const RawOptions& raw)
{
  checkPaths({{"MESH", raw.mesh}, {"--constraints", raw.constraints}}, {{"--report", raw.report}});
  return {raw.mesh, pathOrNone(raw.constraints), pathOrNone(raw.report), statedOptions(raw), raw.isQuiet};
}

}  // namespace

Command parseCommandLine(int argc, const char* const* argv)
{
  RawOptions raw;
  CLI::App app{"Deforms triangle meshes so that chosen points land exactly where they are told to."};
  CLI::App* const deformApp = app.add_subcommand("deform", "Deform a mesh under constraints");
  CLI::App* const checkApp = app.add_subcommand("check", "Diagnose a mesh and its constraints, solve nothing");
  describe(app, *deformApp, *checkApp, raw);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return ShowText{app.help()};
  } catch (const CLI::CallForAllHelp&) {
    return ShowText{app.help("", CLI::AppFormatMode::All)};
  } catch (const CLI::CallForVersion& version) {
    return ShowText{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + ". Run with --help for more information.");
  }
  if (deformApp->parsed()) return deformCommand(raw);
  return checkCommand(raw);
}

}  // namespace holdfast::batch
