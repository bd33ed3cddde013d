#include "support/law_meshes.h"

#include <cmath>
#include <map>

#include <holdfast/mesh/vertex_normals.h>

#include "support/meshes.h"

namespace holdfast::test {
namespace {

/// The faces of both triangles of each pair joined again, as `box` and `grid` make them: (a, b, c), (a, c, d).
Polygons joinedPairs(const Polygons& triangles)
{
  Polygons quads;
  for (Index f = 0; f + 1 < triangles.size(); f += 2) {
    std::map<Index, int> count;
    for (const Index v : triangles[f]) ++count[v];
    for (const Index v : triangles[f + 1]) ++count[v];
    const auto first = triangles[f];
    for (std::size_t k = 0; k < 3; ++k)
      if (count[first[k]] == 1)
        for (const Index v : triangles[f + 1])
          if (count[v] == 1) quads.add({first[k], first[(k + 1) % 3], v, first[(k + 2) % 3]});
  }
  return quads;
}

}  // namespace

std::vector<NamedMesh> lawMeshes()
{
  const Mesh apart = transformed(box(Vector3(1, 1.5, 0.7), 2), Eigen::Affine3d(Eigen::Translation3d(3, 0.2, -1)));
  return {{"icosphere", icosphere(2)},
          {"grid", grid(6, 5)},
          {"box", box(Vector3(1, 2, 3), 3)},
          {"plate", plate(7, 5)},
          {"parts", merged(icosphere(1), apart)},
          {"polygons", polygonPlate(3, 2)}};
}

Mesh plate(Index columns, Index rows)
{
  Mesh mesh{grid(columns, rows).positions, {}};
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double x = mesh.positions(v, 0);
    const double y = mesh.positions(v, 1);
    mesh.positions.row(v) += Eigen::RowVector3d(0.2 * std::sin(1.7 * x + 2.3 * y), 0.2 * std::cos(2.9 * x - 1.3 * y),
                                                0.5 * std::sin(0.9 * x + 0.2 * y * y));
  }
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i;
      const Index c = a + columns + 2;
      if ((7 * i + 3 * j + i * j) % 2 == 0) {
        mesh.faces.add({a, a + 1, c});
        mesh.faces.add({a, c, c - 1});
      } else {
        mesh.faces.add({a, a + 1, c - 1});
        mesh.faces.add({a + 1, c, c - 1});
      }
    }
  return mesh;
}

Mesh polygonPlate(Index columns, Index rows)
{
  Mesh mesh{grid(2 * columns, 2 * rows).positions, {}};
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions(v, 2) = 0.1 * std::sin(0.6 * mesh.positions(v, 0) + 0.8 * mesh.positions(v, 1));
  const Index up = 2 * columns + 1;
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = 2 * j * up + 2 * i;
      const Index middle = a + up + 1;
      mesh.faces.add({a, a + 1, a + 2, middle + 1, middle, middle + up, a + 2 * up, a + up});
      mesh.faces.add({middle, middle + 1, middle + up + 1, middle + up});
    }
  return mesh;
}

Mesh quadBox(const Vector3& size, Index divisions)
{
  Mesh mesh = box(size, divisions);
  mesh.faces = joinedPairs(mesh.faces);
  return mesh;
}

Mesh soup(const Mesh& mesh)
{
  const std::span<const int> vertexOf = mesh.faces.corners();
  Mesh result{Positions(static_cast<Index>(vertexOf.size()), 3), {}};
  for (std::size_t k = 0; k < vertexOf.size(); ++k)
    result.positions.row(static_cast<Index>(k)) = mesh.positions.row(vertexOf[k]);
  Index next = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    std::vector<Index> own(mesh.faces[f].size());
    for (Index& corner : own) corner = next++;
    result.faces.add(own);
  }
  return result;
}

Mesh triangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  Mesh mesh{Positions(3, 3), {}};
  mesh.positions << a.transpose(), b.transpose(), c.transpose();
  mesh.faces.add({0, 1, 2});
  return mesh;
}

Mesh withVertex(Mesh mesh, const Vector3& position)
{
  mesh.positions.conservativeResize(mesh.vertexCount() + 1, 3);
  mesh.positions.row(mesh.vertexCount() - 1) = position;
  return mesh;
}

Mesh withFace(Mesh mesh, std::initializer_list<Index> face)
{
  mesh.faces.add(face);
  return mesh;
}

Mesh moved(const Mesh& mesh, const Vector3& by)
{
  return transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(by)));
}

Mesh transformed(Mesh mesh, const Eigen::Affine3d& motion)
{
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions.row(v) = (motion * Vector3(mesh.positions.row(v))).transpose();
  return mesh;
}

Mesh renumbered(const Mesh& mesh, const std::vector<Index>& newIdOf)
{
  Mesh result{Positions(mesh.vertexCount(), 3), {}};
  for (Index v = 0; v < mesh.vertexCount(); ++v) result.positions.row(newIdOf[v]) = mesh.positions.row(v);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    std::vector<Index> own(mesh.faces[f].begin(), mesh.faces[f].end());
    for (Index& corner : own) corner = newIdOf[corner];
    result.faces.add(own);
  }
  return result;
}

SolverMesh solverMeshOf(const Mesh& mesh)
{
  return makeSolverMesh(mesh, triangulate(mesh));
}

}  // namespace holdfast::test
