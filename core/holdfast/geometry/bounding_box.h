#pragma once
/// \file
/// The axis-aligned box around a mesh. Its diagonal is the length against which exactness is promised.

#include <Eigen/Geometry>

#include <holdfast/base/types.h>

namespace holdfast {

/// Box around all rows of `positions`; empty (`isEmpty()`) where there are none. O(N).
[[nodiscard]] Eigen::AlignedBox3d boundingBox(const Positions& positions);

/// Length of the diagonal of `boundingBox(positions)`, in model units; 0 where there are no positions.
[[nodiscard]] double boundingBoxDiagonal(const Positions& positions);

}  // namespace holdfast
