#pragma once
/// One point of the surface, named as a point of another kind.

#include <holdfast/mesh/mesh.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {

/// In the order of `SurfaceLocation`.
enum class LocationKind { Vertex, Edge, Face, Near };

[[nodiscard]] inline LocationKind kindOf(const SurfaceLocation& location)
{
  return static_cast<LocationKind>(location.index());
}

/// The point of this kind that is nearest to `location`, by positions at rest; `location` itself where it is of the
/// kind. What lies on a vertex or an edge stays there as long as the kind allows it.
/// - vertex: the nearest end of its edge, or corner of its face;
/// - edge: from a vertex the first edge at it in file order, with t = 1; else the nearest side of its face;
/// - face: the first in file order that has the vertex, or both ends of the edge, with the same weights;
/// - near: its place. Where the surface passes that place twice the solver takes the one that comes first.
/// A `near` place is what it lies on: a vertex, an edge of the triangulation, or a face.
///
/// `locator` is that of `mesh`. Throws `InputError` as the locator does for a location that the mesh does not have, and
/// without a place for a vertex that no face uses, or no edge joins to another: it can only be a vertex. O(corners of
/// the mesh).
[[nodiscard]] SurfaceLocation converted(const SurfaceLocation& location, LocationKind kind, const Mesh& mesh,
                                        const SurfaceLocator& locator);

}  // namespace holdfast
