#pragma once
/// \file
/// Where the rotation sphere shows the rotation of a vertex.

#include <optional>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>

namespace holdfast::test {

/// Pixels from the window's lower left corner; none without a point of that vertex, and without a renderer.
inline std::optional<DisplayPoint> displayPlace(const RotationSphere& sphere, Index vertex)
{
  const std::vector<Index>& pointOf = sphere.placed().vertices->pointOf;
  if (sphere.renderer() == nullptr || vertex >= static_cast<Index>(pointOf.size()) || pointOf[vertex] < 0)
    return std::nullopt;
  return DisplayTransform(*sphere.renderer()).show(sphere.placed().places[pointOf[vertex]]).point;
}

}  // namespace holdfast::test
