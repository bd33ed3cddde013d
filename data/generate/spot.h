#pragma once
/// \file
/// Points of a surface found by place and named in the terms of a constraint file.

#include <string>
#include <variant>

#include "grouped_mesh.h"

namespace holdfast::generate {

struct VertexSpot {
  Index vertex;
};
/// A quarter of the way from j to i.
struct EdgeSpot {
  Index i;
  Index j;
};
/// Weights 0.25, 0.25, 0.5.
struct FaceSpot {
  Index face;
};
/// The point of the surface nearest to `rest`.
struct NearSpot {};

struct Spot {
  std::variant<VertexSpot, EdgeSpot, FaceSpot, NearSpot> where;
  Vector3 rest;  ///< to a millionth of a unit
};

enum class SpotKind { kVertex, kEdge, kFace, kNear };

/// The vertex, edge or face of `mesh` whose middle is nearest to `place`, and the point of it that constraints speak
/// of.
[[nodiscard]] Spot findSpot(const GroupedMesh& mesh, SpotKind kind, const Vector3& place);

/// The value of "at".
[[nodiscard]] std::string atText(const Spot& spot);

}  // namespace holdfast::generate
