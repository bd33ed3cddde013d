#pragma once
/// \file
/// Where experiments find and leave their files, and how they run the programs.

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <holdfast/constraints/constraint.h>
#include <holdfast/mesh/mesh.h>

namespace holdfast::paper {

/// Relative to the working folder, which is the root of the project.
struct Folders {
  std::filesystem::path out = "out/paper";               ///< all that is not committed
  std::filesystem::path pictures = "docs/images/paper";  ///< pictures that are
  std::filesystem::path models = "out/paper/models";     ///< fetched models
};

/// A run of `holdfast-batch deform`.
struct BatchRun {
  std::string command;  ///< as a user types it
  int exitCode = 0;     ///< 0, 4 (conflicts) or 5 (no solution)
  nlohmann::json report;
  Mesh mesh;  ///< as it was written; empty with exit code 5

  [[nodiscard]] const nlohmann::json& solve() const { return report.at("solve"); }
  /// What the report says of the constraint of that name. Throws std::out_of_range where there is none.
  [[nodiscard]] const nlohmann::json& constraint(const std::string& name) const;
};

/// Makes the folders of outputs and pictures.
class Workbench {
 public:
  explicit Workbench(Folders folders = {});

  /// Deforms `mesh` under `constraints` (files) with more options of the command line; outputs are called `name`.
  /// Throws std::runtime_error with the program's message for exit codes that no experiment asks for.
  [[nodiscard]] BatchRun deform(const std::string& name, const std::string& mesh, const std::string& constraints,
                                const std::vector<std::string>& options = {}) const;

  /// Runs a program to its end; returns the command as a user types it. Throws std::runtime_error with the program's
  /// message where it fails.
  std::string run(const std::vector<std::string>& command) const;

  /// The path of an input that an experiment makes for itself.
  [[nodiscard]] std::string write(const std::string& name, const Mesh& mesh) const;
  [[nodiscard]] std::string write(const std::string& name, const ConstraintList& list) const;

  [[nodiscard]] std::string out(const std::string& name) const { return (folders_.out / name).string(); }
  /// The path of a picture of the project's own meshes.
  [[nodiscard]] std::string picture(const std::string& name) const { return (folders_.pictures / name).string(); }
  /// The path of a fetched model. Throws std::runtime_error where it is not there.
  [[nodiscard]] std::string model(const std::string& name) const;

 private:
  Folders folders_;
};

/// Writes `bytes` to a file. Throws std::runtime_error where that fails.
void writeFile(const std::string& path, const std::string& bytes);

/// The contents of a text file; empty where there is none.
[[nodiscard]] std::string readFile(const std::string& path);

}  // namespace holdfast::paper
