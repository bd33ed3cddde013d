#pragma once
/// \file
/// The meshes on which every law is tried, and ways to make one mesh of another.

#include <initializer_list>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/mesh/mesh.h>
#include <holdfast/mesh/solver_mesh.h>

namespace holdfast::test {

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

/// A closed surface, a flat open one, one with sharp edges, one without any symmetry, one in two parts, and one of
/// quadrilaterals and concave octagons; all without faults, a few dozen to a few hundred vertices each.
[[nodiscard]] std::vector<NamedMesh> lawMeshes();

/// An open bent plate of triangles of all shapes, without any symmetry.
[[nodiscard]] Mesh plate(Index columns, Index rows);

/// An open bent plate of 2 `columns` x 2 `rows` squares, three of every four joined to an octagon of the shape of an L.
[[nodiscard]] Mesh polygonPlate(Index columns, Index rows);

/// A closed box of quadrilaterals: `divisions` squares along each edge.
[[nodiscard]] Mesh quadBox(const Vector3& size, Index divisions);

/// Every face with vertices of its own, as an STL file has them; corner k of all corners is vertex k.
[[nodiscard]] Mesh soup(const Mesh& mesh);

/// One triangle.
[[nodiscard]] Mesh triangle(const Vector3& a, const Vector3& b, const Vector3& c);

/// `mesh` with one more vertex, or one more face.
[[nodiscard]] Mesh withVertex(Mesh mesh, const Vector3& position);
[[nodiscard]] Mesh withFace(Mesh mesh, std::initializer_list<Index> face);

[[nodiscard]] Mesh moved(const Mesh& mesh, const Vector3& by);

/// Every position moved by `motion`.
[[nodiscard]] Mesh transformed(Mesh mesh, const Eigen::Affine3d& motion);

/// The same surface with vertex v called `newIdOf[v]`.
[[nodiscard]] Mesh renumbered(const Mesh& mesh, const std::vector<Index>& newIdOf);

[[nodiscard]] SolverMesh solverMeshOf(const Mesh& mesh);

}  // namespace holdfast::test
