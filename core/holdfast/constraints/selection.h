#pragma once
/// Sets of vertices, named in the terms of constraint files.

#include <memory>
#include <variant>
#include <vector>

#include <holdfast/mesh/mesh.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

struct Selection;

/// These vertices, by id.
struct VertexIds {
  std::vector<Index> ids;

  friend bool operator==(const VertexIds&, const VertexIds&) = default;
};

/// Vertices in the closed axis-aligned box, at rest.
struct InBox {
  Vector3 min = Vector3::Zero();
  Vector3 max = Vector3::Zero();

  friend bool operator==(const InBox&, const InBox&) = default;
};

/// Vertices in the closed ball, at rest.
struct InSphere {
  Vector3 center = Vector3::Zero();
  double radius = 0;

  friend bool operator==(const InSphere&, const InSphere&) = default;
};

/// Vertices with (p - point) . normal >= 0, at rest. The normal need not be of unit length.
struct InHalfSpace {
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();

  friend bool operator==(const InHalfSpace&, const InHalfSpace&) = default;
};

/// Vertices of one connected part of the mesh, numbered as `check` lists them (see `connectedComponents`).
struct InComponent {
  Index component = 0;

  friend bool operator==(const InComponent&, const InComponent&) = default;
};

/// The side of a closed curve with fewer vertices, or that with more.
enum class CurveSide { Smaller, Larger };

/// Vertices on a closed curve, and on one side of it within the connected part that it lies on. The curve joins places
/// of the surface, at least three, each to the next and the last to the first, along the shortest paths of edges.
/// `regionOfCurve` tells which side is which.
struct InsideCurve {
  std::vector<SurfaceLocation> through;
  CurveSide side = CurveSide::Smaller;

  friend bool operator==(const InsideCurve&, const InsideCurve&) = default;
};

/// Vertices in all / in any of the parts; in none of one part.
struct AllOf {
  std::vector<Selection> parts;

  friend bool operator==(const AllOf&, const AllOf&);
};
struct AnyOf {
  std::vector<Selection> parts;

  friend bool operator==(const AnyOf&, const AnyOf&);
};
struct NotIn {
  std::shared_ptr<const Selection> part;

  friend bool operator==(const NotIn&, const NotIn&);
};

/// Equal where both are stated alike; they may differ and name the same vertices.
struct Selection {
  std::variant<VertexIds, InBox, InSphere, InHalfSpace, InComponent, InsideCurve, AllOf, AnyOf, NotIn> what;

  friend bool operator==(const Selection&, const Selection&);
};

/// The ids that `selection` names, which has none out of range and no curves: ascending, each once; may be none.
/// `componentOf`: the connected part of each vertex, -1 for one that no face uses. Points on the boundary of a shape
/// are inside. `AllOf` nothing is every vertex, `AnyOf` nothing is none. O(N) per node of the expression.
[[nodiscard]] std::vector<Index> select(const Selection& selection, const Positions& positions,
                                        const std::vector<int>& componentOf);

}  // namespace holdfast
