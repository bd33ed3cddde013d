#pragma once
/// \file
/// Solutions as the paper prints them, for comparison only: positions instead of displacements, normal equations that
/// are not scaled, one plain factorisation, no correction, no fallback.

#include <string>

#include "bench/paper/limited.h"
#include "bench/paper/reference.h"

namespace holdfast::paper {

/// What a solver did.
struct Outcome {
  std::string failure;  ///< why it is not solved; empty where all numbers are finite
  double residual = 0;  ///< of constraints, the largest, diagonals
  double error = 0;     ///< largest distance of a vertex to the reference, diagonals
  double seconds = 0;   ///< of processor time on all cores: factorisation and solution

  [[nodiscard]] bool isSolved() const { return failure.empty(); }
};

/// `Outcome::failure` of rows that are not finite, which (10), cotangent weights as printed, has where areas vanish.
inline constexpr const char* kNotFinite = "not finite";

/// A larger error is visible in a picture of the whole mesh: nothing worth the name is solved.
inline constexpr double kLostError = 1e-3;

/// Returns the outcome of displacements `u`, judged by `reference`.
[[nodiscard]] Outcome judged(const BentProblem& problem, const Columns3& u, const Columns3& reference, double seconds);

/// Of one LU factorisation with its solution.
inline constexpr Limits kLuLimits{600, 12};

/// In double precision: Cholesky by CHOLMOD, LU by UMFPACK without its scaling and its refinement.
[[nodiscard]] Outcome solvedInDouble(const BentMesh& bent, const BentProblem& problem, const Method& method,
                                     const Columns3& reference);
/// In single precision, matrices and factors included, both by Eigen.
[[nodiscard]] Outcome solvedInSingle(const BentMesh& bent, const BentProblem& problem, const Method& method,
                                     const Columns3& reference);
/// Solves the problem as the product does, with all that it does.
[[nodiscard]] Outcome solvedByProduct(const BentMesh& bent, const BentProblem& problem, const Method& method,
                                      const Columns3& reference);

}  // namespace holdfast::paper
