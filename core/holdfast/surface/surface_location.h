#pragma once
/// A user names a point of the surface in the terms of the mesh file. `surface_point.h` holds the canonical form that
/// the solver uses.

#include <variant>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// The point of a vertex, equation (4).
struct AtVertex {
  Index vertex = 0;

  friend bool operator==(const AtVertex&, const AtVertex&) = default;
};

/// A point of an edge between two vertices: t p_i + (1 - t) p_j with t in [0, 1], equation (5).
struct AtEdge {
  Index i = 0;
  Index j = 0;
  double t = 0;

  friend bool operator==(const AtEdge&, const AtEdge&) = default;
};

/// A point of a face, equation (6). It has one weight for each corner, in file order. None is negative, and their sum
/// is 1.
struct AtFace {
  Index face = 0;
  std::vector<double> weights;

  friend bool operator==(const AtFace&, const AtFace&) = default;
};

/// The point of the surface at rest that is closest to a place in space, in model units.
struct AtNear {
  Vector3 place = Vector3::Zero();

  friend bool operator==(const AtNear&, const AtNear&) = default;
};

/// One of the four ways to name a point of the surface.
///
///     const SurfaceLocation vertex = AtVertex{12};
///     const SurfaceLocation middleOfEdge = AtEdge{12, 13, 0.5};
///     const SurfaceLocation middleOfFace = AtFace{77, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
///     const SurfaceLocation measured = AtNear{{4.1, 0.2, 0.9}};
using SurfaceLocation = std::variant<AtVertex, AtEdge, AtFace, AtNear>;

}  // namespace holdfast
