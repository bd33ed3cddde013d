#pragma once
/// \file
/// A mesh with constraints generated for it, deformed by holdfast-batch and judged.

#include <filesystem>

#include <nlohmann/json.hpp>

#include <holdfast/operators/operators.h>

#include "support/child_process.h"
#include "support/temporary_folder.h"

namespace holdfast::test {

class GeneratedTask {
 public:
  /// Generates constraints for the mesh from a fixed seed.
  explicit GeneratedTask(const std::filesystem::path& mesh);

  [[nodiscard]] const std::filesystem::path& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const std::filesystem::path& constraints() const noexcept { return constraints_; }
  /// Returns the file that `deform` writes with these weights, in the format of the mesh.
  [[nodiscard]] std::filesystem::path out(Weights weights) const;

  /// Runs holdfast-batch. A run of twenty minutes is given up.
  [[nodiscard]] ProcessResult deform(Weights weights) const;
  /// The report of the last run with these weights.
  [[nodiscard]] nlohmann::json report(Weights weights) const;

  /// Expects a solution that meets the constraints in the written file and in its report, and that has the least
  /// energy.
  void expectSolved(Weights weights) const;
  /// Expects solutions by two weights to differ from one another as two minima do.
  void expectBothLeast(Weights a, Weights b) const;
  /// Expects a solution, or exit code 5 with a reason and without a mesh.
  void expectSolvedOrRefused(Weights weights) const;

 private:
  void expectMet(Weights weights, const ProcessResult& result) const;
  [[nodiscard]] std::filesystem::path reportPath(Weights weights) const;

  std::filesystem::path mesh_;
  TemporaryFolder folder_;
  std::filesystem::path constraints_;
};

}  // namespace holdfast::test
