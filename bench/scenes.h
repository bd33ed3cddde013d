#pragma once
/// \file
/// Lists of constraints that are measured: the same on every run.

#include <holdfast/constraints/constraint.h>
#include <holdfast/mesh/mesh.h>

namespace holdfast::bench {

/// How many points lie on vertices, on edges and in faces. No two of them share a face corner.
struct PointCounts {
  Index vertices = 0;
  Index edges = 0;
  Index faces = 0;
};

/// One end of the mesh (a twentieth of its length) fixed, the other moved aside, and points in between that are moved
/// by a hundredth of its length. As in Fig. 12 of the paper. Triangles only; throws std::runtime_error where the mesh
/// has no room for so many points.
[[nodiscard]] ConstraintList scene(const Mesh& mesh, const PointCounts& counts);

/// The same ends and `count` points in faces of one patch of the surface, about every third of its faces, so that most
/// of them share vertices with others.
[[nodiscard]] ConstraintList overlappingScene(const Mesh& mesh, Index count);

}  // namespace holdfast::bench
