#pragma once
/// The surfaces of the gizmo's parts, in radii of its outer ring, about the origin along the coordinate axes.

#include <array>
#include <vector>

#include <holdfast/widgets/gizmo/gizmo_layout.h>

namespace holdfast {

/// A lit surface of triangles.
struct GizmoShape {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;   ///< of unit length, one a point
  std::vector<double> opacities;  ///< one a point
  std::vector<Vector3> arms;      ///< of rings: from the center to the point's place on the ring; else empty
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise seen from outside
};

/// The shape of a part that is not `None`. The outer ring lies across z.
[[nodiscard]] GizmoShape gizmoShape(GizmoPart part);

}  // namespace holdfast
