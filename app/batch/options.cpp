#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include <holdfast/version.h>
#include <holdfast/words/printable.h>
#include <holdfast/words/spelling.h>

#include "batch/batch.h"

namespace holdfast::batch {
namespace {

/// An option that a session may state as well.
template <class Value, std::size_t Count>
void addChoice(CLI::App& command, const std::string& option, std::optional<Value>& chosen,
               const std::array<Value, Count>& values, Value otherwise)
{
  std::array<std::string_view, Count> names;
  std::transform(values.begin(), values.end(), names.begin(), [](Value value) { return name(value); });
  const auto choose = [=, &chosen](const std::string& text) {
    std::vector<std::string_view> offered;
    for (const Value value : values) {
      if constexpr (std::is_same_v<Value, Backend>)
        if (!isBuilt(value)) continue;
      if (text == name(value)) return void(chosen = value);
      offered.push_back(name(value));
    }
    throw UsageError(fmt::format("{}: {} is not one of {}", option, inQuotes(text), fmt::join(offered, ", ")));
  };
  command.add_option_function<std::string>(
      option, choose,
      fmt::format("{} or {}; default: that of the session, else {}", fmt::join(names.begin(), names.end() - 1, ", "),
                  names.back(), name(otherwise)));
}

void describe(CLI::App& app, CLI::App& deformApp, CLI::App& checkApp, Command& asked)
{
  const DeformOptions defaults;
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 all met, 2 usage, 3 unusable input, 4 constraints conflict, 5 numerical failure,\n"
      "6 an output cannot be written, 70 a bug of ours. See docs/errors.md.");
  for (CLI::App* command : {&app, &deformApp, &checkApp}) {
    command->set_version_flag("--version", std::string("holdfast-batch " HOLDFAST_VERSION));
    command->add_flag("--quiet", asked.isQuiet, "Print neither progress nor the summary");
  }
  for (CLI::App* command : {&deformApp, &checkApp}) {
    command->add_option("mesh", asked.mesh, "Mesh file: " + knownFormats())->required()->type_name("MESH");
    command->add_option("--report", asked.report, "Write the report (JSON) here")->type_name("R.json");
    addChoice(*command, "--weights", asked.options.weights, kAllWeights, defaults.weights);
    addChoice(*command, "--backend", asked.options.backend, kAllBackends, defaults.solver.backend);
    command
        ->add_option("--constraints", asked.constraints,
                     "Constraint file (JSON), session (.holdfast) or point list (.csv, .tsv, .txt, .asc, .xyz)")
        ->required(command == &deformApp)
        ->type_name("C.json");
    command->add_option(
        "--near-limit", asked.options.nearLimit,
        fmt::format(
            "Warn of \"near\" places farther from the surface than this share of the diagonal; default: that of the "
            "session, else {}",
            defaults.nearLimit));
    command->add_option("--weld", asked.options.weldTolerance,
                        "Deform vertices of open edges that lie within this length of one another as one; "
                        "default: that of the session, else those in one place");
    command
        ->add_flag_callback(
            "--skip-bad-rows", [&asked] { asked.badRows = BadRows::Skip; },
            "Leave out rows of a point list that cannot be read; each is named on stderr and in the report")
        ->needs("--constraints");
  }
  const auto add = [&](const char* option, std::string& value, const char* description, const char* type) {
    return deformApp.add_option(option, value, description)->type_name(type);
  };
  add("--out", asked.out, "Write the deformed mesh here, in the format of the name", "MESH");
  add("--fields", asked.fields, "Write residuals, displacements, rotations and forces on the mesh here", "F.vtp");
  CLI::Option* const snapshot = add("--snapshot", asked.picture.path, "Draw the deformed mesh into this file", "P.png");
  const std::string colors = "Colours of the picture: " + knownColorings();
  add("--color-by", asked.picture.colorBy, colors.c_str(), "FIELD")->needs(snapshot)->capture_default_str();
  add("--size", asked.picture.size, "Size of the picture in pixels", "WxH")->needs(snapshot)->capture_default_str();
  addChoice(deformApp, "--solver", asked.options.solver, kAllSolvers, defaults.solver.kind);
  addChoice(deformApp, "--rotations", asked.options.rotations, kAllRotations, defaults.rotations.source);
  deformApp.add_option(
      "--rotation-change", asked.options.rotationChange,
      fmt::format("Rotations are found when an iteration moves no vertex by more than this share of the diagonal; "
                  "default: that of the session, else {}",
                  defaults.rotations.change));
  deformApp.add_option(
      "--soft-weight", asked.options.softWeight,
      fmt::format("Weight of the constraints of the solver soft; default: that of the session, else {}",
                  defaults.solver.softWeight));
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

/// Tells whether both names lead to one file, which need not exist. Hard links of one file count as one.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b)
{
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored) || writtenFile(a) == writtenFile(b);
}

/// A device or a pipe can take several outputs.
bool isFile(const std::string& path)
{
  std::error_code ignored;
  return !path.empty() && (!std::filesystem::exists(path, ignored) || std::filesystem::is_regular_file(path, ignored));
}

/// No output may take the place of another or of an input.
void checkPaths(const Command& asked)
{
  const std::vector<std::pair<const char*, std::string>> outputs{
      {"--out", asked.out}, {"--report", asked.report}, {"--fields", asked.fields}, {"--snapshot", asked.picture.path}};
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    const auto& [option, path] = *output;
    if (!isFile(path)) continue;
    for (const std::string& input : {asked.mesh, asked.constraints})
      if (!input.empty() && isSameFile(path, input))
        throw UsageError(
            fmt::format("{} would overwrite the input \"{}\"; choose another name", option, printable(input)));
    for (auto other = outputs.begin(); other != output; ++other)
      if (!other->second.empty() && isSameFile(path, other->second))
        throw UsageError(fmt::format("{} and {} name the same file \"{}\"; choose another name for one of them",
                                     other->first, option, printable(path)));
  }
}

void requirePositive(const char* option, const std::optional<double>& value)
{
  if (value && !(*value > 0 && std::isfinite(*value)))
    throw UsageError(fmt::format("{}: {} is not a positive number", option, *value));
}

void check(const Command& asked)
{
  checkPaths(asked);
  requireFormats(asked);
  requirePositive("--soft-weight", asked.options.softWeight);
  requirePositive("--rotation-change", asked.options.rotationChange);
  requirePositive("--near-limit", asked.options.nearLimit);
  requirePositive("--weld", asked.options.weldTolerance);
}

/// What is wrong with the first argument that means nothing; empty where there is none.
std::string unknownArgument(const CLI::App& app)
{
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty()) return "";
  std::vector<std::string> known;
  const std::vector<const CLI::App*> given = app.get_subcommands({});
  const auto parsed = std::ranges::find_if(given, [](const CLI::App* command) { return command->parsed(); });
  if (parsed == given.end())
    for (const CLI::App* command : given) known.push_back(command->get_name());
  else
    for (const CLI::Option* option : (*parsed)->get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::vector<std::string_view> words(known.begin(), known.end());
  const auto closest = closestSpelling(unknown.front(), words);
  return fmt::format("{} is not known{}", inQuotes(unknown.front()),
                     closest ? fmt::format("; did you mean {}?", *closest) : ".");
}

}  // namespace

std::function<ExitCode()> parseCommandLine(int argc, const char* const* argv)
{
  Command asked;
  CLI::App app{"Deforms triangle meshes so that chosen points reach their targets exactly."};
  CLI::App* const deformApp = app.add_subcommand("deform", "Deform a mesh under constraints");
  CLI::App* const checkApp = app.add_subcommand("check", "Diagnose a mesh and its constraints, solve nothing");
  describe(app, *deformApp, *checkApp, asked);
  const auto show = [](const std::string& text) {
    return [text] {
      printResult(text);
      return kAllMet;
    };
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return show(app.help());
  } catch (const CLI::CallForAllHelp&) {
    return show(app.help("", CLI::AppFormatMode::All));
  } catch (const CLI::CallForVersion& version) {
    return show(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknownArgument(app);
    throw UsageError((unknown.empty() ? std::string(error.what()) + "." : unknown) +
                     " Run with --help for more information.");
  }
  check(asked);
  const auto run = deformApp->parsed() ? runDeform : runCheck;
  return [=] { return run(asked); };
}

}  // namespace holdfast::batch
