#pragma once
/// \file
/// The point of an edge that is shown nearest to a point of the screen.

#include <optional>

#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {

struct PointOfEdge {
  double share = 0;  ///< the place is a + share (b - a), in [0, 1]
  Vector3 place = Vector3::Zero();
  double distance = 0;  ///< on the screen, pixels
};

/// Of the points of the segment from `a` to `b`; none where all of it lies behind the eye.
[[nodiscard]] std::optional<PointOfEdge> nearestOfEdge(const Vector3& a, const Vector3& b, const DisplayPoint& point,
                                                       const DisplayTransform& display);

}  // namespace holdfast
