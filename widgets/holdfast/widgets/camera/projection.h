#pragma once
/// \file
/// A camera's transforms as matrices.

#include <Eigen/Core>

class vtkRenderer;

namespace holdfast {

/// From places of the model to the axes of the renderer's camera: x to the right, y up, z towards the eye at 0.
[[nodiscard]] Eigen::Matrix4d viewOf(vtkRenderer& renderer);

/// From these axes to the cube of [-1, 1] across the viewport. The camera's clipping range, which follows whatever is
/// drawn, has no part in it: otherwise the same click would name another place, by rounding, where something else is
/// drawn as well. So depths within the cube say nothing.
[[nodiscard]] Eigen::Matrix4d projectionOf(vtkRenderer& renderer);

}  // namespace holdfast
