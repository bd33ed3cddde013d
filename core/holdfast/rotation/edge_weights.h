#pragma once
/// Edge weights say how strongly the edges of a mesh tie the rotations of their ends together.

#include <vector>

#include <holdfast/operators/laplacian.h>
#include <holdfast/operators/operators.h>

namespace holdfast {

/// The smallest weight of an edge with `Weights::Cotangent`. Across an obtuse angle cotangents would push the rotations
/// of the ends apart, out of the hull of those that are given. Across two right angles they would leave them untied.
///
/// A field that cotangents alone define changes by no more than a millionth through so small a weight. It also leaves
/// weights within 4e7 of one another, whose square root is all that sparse QR sees.
inline constexpr double kRotationWeightFloor = 1e-6;

struct RotationWeights {
  std::vector<EdgeWeight> edges;  ///< each once
  std::vector<Index> capped;      ///< unknowns of triangles whose cotangents were held within the cap, ascending
  std::vector<Index> floored;     ///< both ends of each edge whose weight was negative, by more than the floor
};

/// Returns the weights w_ij of the Dirichlet energy sum of w_ij |q_i - q_j|^2, on every edge of the mesh. None depends
/// on the scale of the model. O(T).
///
/// With `Weights::Uniform` a weight is 1. With `Weights::Cotangent` it is the sum of the guarded cotangents across the
/// edge, not below `kRotationWeightFloor`. With `Weights::CotangentPaper` it has the cotangents of (10) as they are.
/// These are negative across obtuse angles and not finite beside triangles without area.
[[nodiscard]] RotationWeights rotationEdgeWeights(const Operators& operators);

}  // namespace holdfast
