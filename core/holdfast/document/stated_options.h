#pragma once
/// Options of a deformation as a session or a command line states them: any of them may be left out.

#include <filesystem>
#include <optional>

#include <holdfast/deform/deform.h>

namespace holdfast {

struct StatedOptions {
  std::optional<Weights> weights;
  std::optional<SolverKind> solver;
  std::optional<double> softWeight;
  std::optional<Backend> backend;

  friend bool operator==(const StatedOptions&, const StatedOptions&) = default;
};

/// `options` with what is stated in place of their own.
[[nodiscard]] inline DeformOptions withStated(DeformOptions options, const StatedOptions& stated)
{
  options.weights = stated.weights.value_or(options.weights);
  options.solver.kind = stated.solver.value_or(options.solver.kind);
  options.solver.softWeight = stated.softWeight.value_or(options.solver.softWeight);
  options.solver.backend = stated.backend.value_or(options.solver.backend);
  return options;
}

/// What `stated` says and `stronger` does not.
[[nodiscard]] inline StatedOptions beside(const StatedOptions& stronger, StatedOptions stated)
{
  if (stronger.weights) stated.weights.reset();
  if (stronger.solver) stated.solver.reset();
  if (stronger.softWeight) stated.softWeight.reset();
  if (stronger.backend) stated.backend.reset();
  return stated;
}

/// Constraints, and the options that their file states.
struct StatedConstraints {
  ConstraintList list;
  StatedOptions options;
};

/// Reads a constraint file, a point list or a session as `readConstraints` does, and the options of a session.
/// Throws `InputError`.
[[nodiscard]] StatedConstraints readStatedConstraints(const std::filesystem::path& path);

}  // namespace holdfast
