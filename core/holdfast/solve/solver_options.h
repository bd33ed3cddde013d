#pragma once
/// \file
/// Which solver, on which library.

#include <string_view>

namespace holdfast {

/// The library that does the numerical work.
enum class Backend {
  Cholmod,  ///< SuiteSparse: CHOLMOD, SPQR, UMFPACK
  Eigen
};

/// The name in files and options: "cholmod", "eigen".
[[nodiscard]] std::string_view name(Backend backend);

/// CHOLMOD where it is built, Eigen otherwise.
[[nodiscard]] Backend defaultBackend();

enum class SolverKind {
  Hard,     ///< constraints eliminated, (11) to (21): exact
  Soft,     ///< soft constraints as weighted rows, (7) and (8): for comparison
  Lagrange  ///< constraints by Lagrange multipliers, end of section 3.2: for comparison
};

/// The name in files and options: "hard", "soft", "lagrange".
[[nodiscard]] std::string_view name(SolverKind kind);

struct SolverOptions {
  SolverKind kind = SolverKind::Hard;
  Backend backend = defaultBackend();
  /// w of soft constraints, (7) and (8), for models measured in diagonals of their bounding box
  double softWeight = 5;

  friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

}  // namespace holdfast
