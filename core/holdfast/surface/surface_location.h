#pragma once
/// How a user names a point of the surface, in the terms of the mesh file. `surface_point.h` holds the canonical form
/// that the solver uses.

#include <variant>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// The point of a vertex, equation (4).
struct AtVertex {
  Index vertex = 0;

  friend bool operator==(const AtVertex&, const AtVertex&) = default;
};

/// A point of the segment between two vertices joined by an edge: t p_i + (1 - t) p_j with t in [0, 1], equation (5).
struct AtEdge {
  Index i = 0;
  Index j = 0;
  double t = 0;

  friend bool operator==(const AtEdge&, const AtEdge&) = default;
};

/// A point of a face: one weight for each corner in file order, none negative, of sum 1, equation (6).
struct AtFace {
  Index face = 0;
  std::vector<double> weights;

  friend bool operator==(const AtFace&, const AtFace&) = default;
};

/// The point of the surface that is closest to a place in space, in model units, on the mesh at rest.
struct AtNear {
  Vector3 place = Vector3::Zero();

  friend bool operator==(const AtNear&, const AtNear&) = default;
};

using SurfaceLocation = std::variant<AtVertex, AtEdge, AtFace, AtNear>;

}  // namespace holdfast
