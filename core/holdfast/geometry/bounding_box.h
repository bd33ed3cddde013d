#pragma once
/// The axis-aligned box around a mesh. Its diagonal is the length against which exactness is promised.

#include <Eigen/Geometry>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns the box around all rows of `positions`. It is empty (`isEmpty()`) where there are none. O(N).
[[nodiscard]] inline Eigen::AlignedBox3d boundingBox(const Positions& positions)
{
  if (positions.rows() == 0) return {};
  return {Vector3(positions.colwise().minCoeff()), Vector3(positions.colwise().maxCoeff())};
}

/// Returns the length of the diagonal of `boundingBox(positions)`, in model units. It is 0 where there are no
/// positions.
[[nodiscard]] inline double boundingBoxDiagonal(const Positions& positions)
{
  return positions.rows() == 0 ? 0.0 : boundingBox(positions).diagonal().stableNorm();
}

}  // namespace holdfast
