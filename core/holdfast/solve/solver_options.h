#pragma once
/// \file
/// These options say which solver is used, on which library.

#include <string_view>

namespace holdfast {

/// A backend does the numerical work.
enum class Backend {
  Holdfast,  ///< our own Cholesky factorisation; what it does not do is done by SuiteSparse or, without that, by Eigen
  Cholmod,   ///< SuiteSparse: CHOLMOD, SPQR, UMFPACK
  Eigen
};

/// Returns the name of the backend in files and options: "holdfast", "cholmod", "eigen".
[[nodiscard]] std::string_view name(Backend backend);

/// Tells whether the backend is part of this program. SuiteSparse may be left out.
[[nodiscard]] bool isBuilt(Backend backend);

/// A solver meets the constraints in one of these ways.
enum class SolverKind {
  Hard,     ///< constraints eliminated, (11) to (21): it meets them exactly
  Soft,     ///< soft constraints as weighted rows, (7) and (8): for comparison
  Lagrange  ///< for comparison: it meets the constraints by Lagrange multipliers, end of section 3.2
};

/// Returns the name of the kind in files and options: "hard", "soft", "lagrange".
[[nodiscard]] std::string_view name(SolverKind kind);

/// The solver, and the numbers that it needs.
///
///     DeformOptions options;
///     options.solver.kind = SolverKind::Soft;
///     options.solver.softWeight = 50;
///     if (isBuilt(Backend::Cholmod)) options.solver.backend = Backend::Cholmod;
///     const DeformResult compromise = deform(model, constraints, "constraints", options);
struct SolverOptions {
  SolverKind kind = SolverKind::Hard;
  Backend backend = Backend::Holdfast;  ///< with one that is not built the status is `Failed`
  /// The weight w of soft constraints, (7) and (8), for models measured in diameters of the smallest sphere around
  /// them. It has to be positive and finite. With any other weight the status of a soft solution is `Failed`.
  double softWeight = 5;

  friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

}  // namespace holdfast
