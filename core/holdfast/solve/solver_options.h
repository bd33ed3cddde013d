#pragma once
/// \file
/// Which solver, on which library.

#include <string_view>

namespace holdfast {

/// Who does the numerical work.
enum class Backend {
  Holdfast,  ///< our own Cholesky factorisation; what it does not do is done by SuiteSparse or, without that, by Eigen
  Cholmod,   ///< SuiteSparse: CHOLMOD, SPQR, UMFPACK
  Eigen
};

/// The name in files and options: "holdfast", "cholmod", "eigen".
[[nodiscard]] std::string_view name(Backend backend);

/// Whether it is part of this program: SuiteSparse may be left out.
[[nodiscard]] bool isBuilt(Backend backend);

enum class SolverKind {
  Hard,     ///< constraints eliminated, (11) to (21): exact
  Soft,     ///< soft constraints as weighted rows, (7) and (8): for comparison
  Lagrange  ///< constraints by Lagrange multipliers, end of section 3.2: for comparison
};

/// The name in files and options: "hard", "soft", "lagrange".
[[nodiscard]] std::string_view name(SolverKind kind);

struct SolverOptions {
  SolverKind kind = SolverKind::Hard;
  Backend backend = Backend::Holdfast;
  /// w of soft constraints, (7) and (8), for models measured in diameters of the smallest sphere around them
  double softWeight = 5;

  friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

}  // namespace holdfast
