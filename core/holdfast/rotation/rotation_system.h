#pragma once
/// \file
/// The equations of the rotation field, (25) to (29), for what is left to find.

#include <vector>

#include <holdfast/rotation/rotation_unknowns.h>

namespace holdfast {

/// What a given rotation asks of an equation: `weight` times its difference from another given one.
struct RotationPull {
  Index row = 0;
  double weight = 0;
  Index given = 0;      ///< place in `prescribed`
  Index reference = 0;  ///< place in `prescribed`
};

/// C z is to be near the sum of the pulls, z being how far the free rotations are from those that `referenceOf` names:
/// where all that are given agree, z is 0 without rounding.
struct RotationSystem {
  SparseMatrix C;  ///< rows x columnCount
  std::vector<RotationPull> pulls;
};

/// A row for each edge with a free end, sqrt(w_ij) (q_i - q_j): least squares of them minimise the Dirichlet energy. No
/// weight is negative.
[[nodiscard]] RotationSystem energyRows(const std::vector<EdgeWeight>& weights, const RotationUnknowns& unknowns);

/// A row for each column, the sum of w_ij (q_i - q_j) over its unknowns and their neighbours, of L q = 0, (25), by the
/// size of its largest coefficient. Square, for weights of any sign.
[[nodiscard]] RotationSystem balanceRows(const std::vector<EdgeWeight>& weights, const RotationUnknowns& unknowns);

}  // namespace holdfast
