#pragma once
/// A row of B that is a combination of others.

#include <vector>

#include <holdfast/base/term.h>

namespace holdfast {

/// b_row = sum of coefficient * b_index over independent rows: a circuit, no smaller set of rows depends. Terms ascend.
/// Without terms the row is empty: it says 0 = d.
struct Dependency {
  Index row = 0;
  std::vector<Term> terms;
};

/// Coefficients smaller than this are rounding of zero: as a share of the largest coefficient of the circuit where that
/// exceeds 1, as it does in circuits that lead from face to face. (Barycentric numbers of points that can be told apart
/// are larger.)
inline constexpr double kCoefficientThreshold = 1e-10;

}  // namespace holdfast
