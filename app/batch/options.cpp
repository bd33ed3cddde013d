#include "batch/options.h"

#include <algorithm>
#include <map>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "batch/mesh_formats.h"

namespace holdfast::batch {
namespace {

const std::map<std::string, Weights> kWeights{
    {"cotangent", Weights::Cotangent}, {"cotangent-paper", Weights::CotangentPaper}, {"uniform", Weights::Uniform}};
const std::map<std::string, SolverKind> kSolvers{
    {"hard", SolverKind::Hard}, {"soft", SolverKind::Soft}, {"lagrange", SolverKind::Lagrange}};

std::map<std::string, Backend> backends()
{
  std::map<std::string, Backend> result{{"eigen", Backend::Eigen}};
  if (defaultBackend() == Backend::Cholmod) result.emplace("cholmod", Backend::Cholmod);
  return result;
}

/// The value of an option that has a few.
template <class Value>
Value chosen(const std::string& option, const std::string& text, const std::map<std::string, Value>& values)
{
  if (const auto found = values.find(text); found != values.end()) return found->second;
  std::string known;
  for (const auto& [key, value] : values) known += (known.empty() ? "" : ", ") + key;
  throw UsageError(fmt::format("{}: \"{}\" is not one of {}", option, text, known));
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
  std::string weights = "cotangent";
  std::string solver = "hard";
  std::string backend{name(defaultBackend())};
  double softWeight = 5;
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

void describe(CLI::App& app, CLI::App& deformApp, CLI::App& checkApp, RawOptions& raw)
{
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
    command->add_option("--weights", raw.weights, "cotangent, cotangent-paper or uniform")->capture_default_str();
    command->add_option("--backend", raw.backend, "cholmod or eigen")->capture_default_str();
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
  deformApp.add_option("--solver", raw.solver, "hard, soft or lagrange")->capture_default_str();
  deformApp.add_option("--soft-weight", raw.softWeight, "Weight of the constraints of the solver soft")
      ->capture_default_str();
}

std::optional<std::filesystem::path> pathOrNone(const std::string& text)
{
  if (text.empty()) return std::nullopt;
  return std::filesystem::path(text);
}

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b)
{
  std::error_code ignored;
  return std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored);
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
        throw UsageError(
            fmt::format("{} would overwrite the input \"{}\"; choose another name", outputs[k].option, input.path));
    for (std::size_t other = 0; other < k; ++other)
      if (!outputs[other].path.empty() && isSameFile(outputs[k].path, outputs[other].path))
        throw UsageError(fmt::format("{} and {} name the same file \"{}\"; choose another name for one of them",
                                     outputs[other].option, outputs[k].option, outputs[k].path));
  }
}

/// What the names of weights, solver and backend mean.
DeformOptions deformOptions(const RawOptions& raw)
{
  return {chosen("--weights", raw.weights, kWeights),
          {chosen("--solver", raw.solver, kSolvers), chosen("--backend", raw.backend, backends()), raw.softWeight}};
}

DeformCommand deformCommand(const RawOptions& raw)
{
  checkPaths({{"MESH", raw.mesh}, {"--constraints", raw.constraints}},
             {{"--out", raw.out}, {"--report", raw.report}, {"--fields", raw.fields}, {"--snapshot", raw.snapshot}});
  if (!raw.out.empty()) requireMeshExtension(raw.out);
  if (!raw.fields.empty()) requireFieldsExtension(raw.fields);
  if (!(raw.softWeight > 0) || !std::isfinite(raw.softWeight))
    throw UsageError(fmt::format("--soft-weight: {} is not a positive number", raw.softWeight));
  const DeformOptions options = deformOptions(raw);
  std::optional<PictureRequest> picture;
  if (!raw.snapshot.empty()) picture = pictureRequest(raw.snapshot, raw.colorBy, raw.size);
  if (picture && picture->colorBy == "force" && options.solver.kind != SolverKind::Hard)
    throw UsageError("--color-by: forces are known with --solver hard only; choose another colouring or that solver");
  return {raw.mesh, raw.constraints, pathOrNone(raw.out), pathOrNone(raw.report), pathOrNone(raw.fields),
          picture,  options,         raw.isQuiet};
}

CheckCommand checkCommand(const RawOptions& raw)
{
  checkPaths({{"MESH", raw.mesh}, {"--constraints", raw.constraints}}, {{"--report", raw.report}});
  return {raw.mesh, pathOrNone(raw.constraints), pathOrNone(raw.report), deformOptions(raw), raw.isQuiet};
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
    throw UsageError(std::string(error.what()) + "\nRun with --help for more information.");
  }
  if (deformApp->parsed()) return deformCommand(raw);
  return checkCommand(raw);
}

}  // namespace holdfast::batch
