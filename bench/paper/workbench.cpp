#include "bench/paper/workbench.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/io/mesh_file.h>

namespace holdfast::paper {
namespace {

constexpr int kConflicts = 4;
constexpr int kNoSolution = 5;
constexpr const char* kMessages = "messages.txt";  // of the last program

/// The command with the program's name in place of its path.
std::string asTyped(std::vector<std::string> command)
{
  command.front() = std::filesystem::path(command.front()).filename();
  return fmt::format("{}", fmt::join(command, " "));
}

/// Returns `word` as one word of a shell.
std::string quoted(const std::string& word)
{
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Runs it to its end, its messages into a file. -1 where no exit code came of it.
int exitCodeOf(const std::vector<std::string>& command, const std::string& messages)
{
  std::string line;
  for (const std::string& word : command) line += quoted(word) + ' ';
  const int status = std::system((line + ">/dev/null 2>" + quoted(messages)).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

[[noreturn]] void fail(const std::vector<std::string>& command, const std::string& message)
{
  throw std::runtime_error(asTyped(command) + "\nfailed: " + message);
}

}  // namespace

const nlohmann::json& BatchRun::constraint(const std::string& name) const
{
  for (const nlohmann::json& outcome : report.at("constraints"))
    if (outcome.at("name") == name) return outcome;
  throw std::out_of_range("the report has no constraint \"" + name + '"');
}

Workbench::Workbench(Folders folders) : folders_(std::move(folders))
{
  std::filesystem::create_directories(folders_.out);
  std::filesystem::create_directories(folders_.pictures);
}

BatchRun Workbench::deform(const std::string& name, const std::string& mesh, const std::string& constraints,
                           const std::vector<std::string>& options) const
{
  std::vector<std::string> command{HOLDFAST_BATCH, "deform", mesh, "--constraints", constraints};
  command.insert(command.end(), options.begin(), options.end());
  BatchRun run{asTyped(command), 0, {}, {}};
  const std::string deformed = out(name + ".ply");
  const std::string report = out(name + ".json");
  command.insert(command.end(), {"--out", deformed, "--report", report, "--quiet"});
  run.exitCode = exitCodeOf(command, out(kMessages));
  if (run.exitCode != 0 && run.exitCode != kConflicts && run.exitCode != kNoSolution)
    fail(command, readFile(out(kMessages)));
  run.report = nlohmann::json::parse(readFile(report));
  if (run.exitCode != kNoSolution) run.mesh = readMesh(deformed).mesh;
  return run;
}

std::string Workbench::run(const std::vector<std::string>& command) const
{
  if (exitCodeOf(command, out(kMessages)) != 0) fail(command, readFile(out(kMessages)));
  return asTyped(command);
}

std::string Workbench::write(const std::string& name, const Mesh& mesh) const
{
  writeMesh(out(name), {mesh, nullptr}, mesh.positions);
  return out(name);
}

std::string Workbench::write(const std::string& name, const ConstraintList& list) const
{
  writeFile(out(name), constraintsToJson(list));
  return out(name);
}

std::string Workbench::model(const std::string& name) const
{
  const std::filesystem::path path = folders_.models / name;
  if (!std::filesystem::exists(path))
    throw std::runtime_error(path.string() + " is not there; scripts/paper.sh fetches it");
  return path.string();
}

void writeFile(const std::string& path, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file << bytes << std::flush;
  if (!file) throw std::runtime_error(path + " cannot be written");
}

std::string readFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace holdfast::paper
