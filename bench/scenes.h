#pragma once
/// \file
/// Lists of constraints that are measured: the same on every run.

#include <holdfast/constraints/constraint.h>
#include <holdfast/mesh/mesh.h>

namespace holdfast::bench {

/// In front of the points of each list: one end of the mesh (a twentieth of its length) is fixed, the other one is
/// moved aside and turned by a handle. The meshes are of triangles.
inline constexpr std::size_t kEnds = 2;

/// Returns the constraints of Fig. 12 of the paper: 300 isolated points each on vertices, on edges and in faces, fewer
/// on small meshes, that move by a hundredth of the length. Another `set` has other points.
[[nodiscard]] ConstraintList scene(const Mesh& mesh, std::uint32_t set = 0);

/// `count` points in faces that share no vertex. Throws std::runtime_error where the mesh has no room for them.
[[nodiscard]] ConstraintList isolatedFacePoints(const Mesh& mesh, Index count);

/// `count` points in random ones of the `among` faces nearest to one another, as far as there are so many: where that
/// is three times as many, most of them share vertices with others.
[[nodiscard]] ConstraintList overlappingFacePoints(const Mesh& mesh, Index count, Index among);

/// Turns the handle of a list by so many degrees from rest.
void turnHandle(ConstraintList& list, double degrees);

/// Moves it by this along x.
void moveHandle(ConstraintList& list, double by);

}  // namespace holdfast::bench
