#pragma once
/// \file
/// A row of B that is a combination of others.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// The part that one independent row has in a dependent one.
struct Partner {
  Index row = 0;
  double coefficient = 0;
};

/// b_row = sum of coefficient * b_partner over independent rows: a circuit, no smaller set of rows depends. Partners
/// ascend. Without partners the row is empty: it says 0 = d.
struct Dependency {
  Index row = 0;
  std::vector<Partner> partners;
};

/// Coefficients smaller than this are rounding of zero: as a share of the largest coefficient of the circuit where that
/// exceeds 1, as it does in circuits that lead from face to face. (Barycentric numbers of points that can be told apart
/// are larger.)
inline constexpr double kPartnerThreshold = 1e-10;

}  // namespace holdfast
