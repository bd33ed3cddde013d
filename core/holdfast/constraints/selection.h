#pragma once
/// Selections name sets of vertices in the terms of constraint files.

#include <memory>
#include <variant>
#include <vector>

#include <holdfast/mesh/mesh.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

struct Selection;

/// Selects these vertices, by id.
struct VertexIds {
  std::vector<Index> ids;

  friend bool operator==(const VertexIds&, const VertexIds&) = default;
};

/// Selects the vertices that lie at rest in the closed axis-aligned box.
struct InBox {
  Vector3 min = Vector3::Zero();
  Vector3 max = Vector3::Zero();

  friend bool operator==(const InBox&, const InBox&) = default;
};

/// Selects the vertices that lie at rest in the closed ball.
struct InSphere {
  Vector3 center = Vector3::Zero();
  double radius = 0;

  friend bool operator==(const InSphere&, const InSphere&) = default;
};

/// Selects the vertices whose place p at rest has (p - point) . normal >= 0. The normal need not be of unit length.
struct InHalfSpace {
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();

  friend bool operator==(const InHalfSpace&, const InHalfSpace&) = default;
};

/// Selects the vertices of one connected part of the mesh. Parts are numbered as `check` lists them (see
/// `componentOfVertices`).
struct InComponent {
  Index component = 0;

  friend bool operator==(const InComponent&, const InComponent&) = default;
};

/// A closed curve has a side with fewer vertices and a side with more.
enum class CurveSide { Smaller, Larger };

/// Selects the vertices on a closed curve, and those on one side of it within the connected part that it lies on. The
/// curve goes through at least three places of the surface. It joins each to the next, and the last to the first, along
/// the shortest paths of edges. `regionOfCurve` tells which side is which.
struct InsideCurve {
  std::vector<SurfaceLocation> through;
  CurveSide side = CurveSide::Smaller;

  friend bool operator==(const InsideCurve&, const InsideCurve&) = default;
};

/// Selects the vertices that all of the parts select.
struct AllOf {
  std::vector<Selection> parts;

  friend bool operator==(const AllOf&, const AllOf&);
};

/// Selects the vertices that any of the parts selects.
struct AnyOf {
  std::vector<Selection> parts;

  friend bool operator==(const AnyOf&, const AnyOf&);
};

/// Selects the vertices that its part does not select.
struct NotIn {
  std::shared_ptr<const Selection> part;

  friend bool operator==(const NotIn&, const NotIn&);
};

/// Selects the vertices that its part selects, and all to which no more than `rings` edges lead from one of them.
/// Vertices that are one unknown go together. A border with its next ring keeps its tangents.
struct Grown {
  std::shared_ptr<const Selection> part;
  Index rings = 1;  ///< 0 or more

  friend bool operator==(const Grown&, const Grown&);
};

/// One of the ways to select vertices. Two selections are equal where both are stated alike. Selections that differ may
/// still name the same vertices.
struct Selection {
  std::variant<VertexIds, InBox, InSphere, InHalfSpace, InComponent, InsideCurve, AllOf, AnyOf, NotIn, Grown> what;

  friend bool operator==(const Selection&, const Selection&);
};

/// Returns the ids that `selection` names, ascending, each once; there may be none. The selection has no id out of
/// range, no curves and no rings. `componentOf` has the connected part of each vertex, -1 for a vertex that no face
/// uses. Points on the boundary of a shape are inside. `AllOf` without parts is every vertex, `AnyOf` without parts is
/// none. O(N) for each node of the expression.
///
///     const InHalfSpace back{{0, 1, 0}, {0, 1, 0}};
///     AllOf rim;  // of a hole, without its back
///     rim.parts.push_back({InSphere{{20, 0, 5}, 2}});
///     rim.parts.push_back({NotIn{std::make_shared<const Selection>(Selection{back})}});
///     const std::vector<Index> ids = select({rim}, model.mesh.positions, componentOfVertices(model.solverMesh));
[[nodiscard]] std::vector<Index> select(const Selection& selection, const Positions& positions,
                                        const std::vector<int>& componentOf);

}  // namespace holdfast
