#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/surface/edge_graph.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/path_lengths.h"

namespace holdfast {
namespace {

using test::solverMeshOf;
using testing::ElementsAre;
using testing::IsEmpty;

/// Meshes of triangles whose vertices are the unknowns.
std::vector<Mesh> meshes()
{
  return {test::plate(6, 5), test::icosphere(1), test::grid(5, 4), test::box(Vector3(1, 2, 3), 2)};
}

double lengthOf(const std::vector<Index>& path, const Mesh& mesh)
{
  double sum = 0;
  for (std::size_t k = 1; k < path.size(); ++k)
    sum += (mesh.positions.row(path[k]) - mesh.positions.row(path[k - 1])).norm();
  return sum;
}

TEST(EdgeGraph, HasTheEdgesOfTheTrianglesInBothDirections)
{
  for (const Mesh& mesh : meshes()) {
    const SolverMesh solverMesh = solverMeshOf(mesh);
    const EdgeGraph graph(solverMesh);
    ASSERT_EQ(graph.vertexCount(), mesh.vertexCount());
    std::vector<std::set<Index>> expected(static_cast<std::size_t>(mesh.vertexCount()));
    for (Index f = 0; f < mesh.faces.size(); ++f)
      for (const Index a : mesh.faces[f])
        for (const Index b : mesh.faces[f])
          if (a != b) expected[a].insert(b);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_THAT(graph.neighbours(v), testing::ElementsAreArray(expected[v]));
      for (const Index neighbour : graph.neighbours(v))
        EXPECT_NEAR(graph.length(v, neighbour) * solverMesh.diagonal,
                    (mesh.positions.row(v) - mesh.positions.row(neighbour)).norm(), 1e-14);
    }
  }
}

TEST(ShortestPaths, AreNoLongerThanAnyOther)
{
  for (const Mesh& mesh : meshes()) {
    const EdgeGraph graph(solverMeshOf(mesh));
    const Eigen::MatrixXd lengths = test::pathLengths(mesh);
    for (Index from = 0; from < mesh.vertexCount(); ++from)
      for (Index to = 0; to < mesh.vertexCount(); ++to) {
        const std::vector<Index> path = shortestPath(graph, from, to);
        ASSERT_FALSE(path.empty());
        EXPECT_EQ(path.front(), from);
        EXPECT_EQ(path.back(), to);
        EXPECT_NEAR(lengthOf(path, mesh), lengths(from, to), 1e-13);
        for (std::size_t k = 1; k < path.size(); ++k)
          EXPECT_THAT(graph.neighbours(path[k - 1]), testing::Contains(path[k])) << "along edges";
      }
  }
}

TEST(ShortestPaths, OfTheSameLengthGoByIds)
{
  const EdgeGraph graph(solverMeshOf(test::grid(3, 3)));
  // From (0, 3) to (3, 0) across the diagonals of the squares there are many; seen from the end the smallest ids.
  const std::vector<Index> first = shortestPath(graph, 12, 3);
  EXPECT_EQ(first.size(), 7U);
  EXPECT_THAT(first, ElementsAre(12, 8, 4, 0, 1, 2, 3));
}

TEST(ShortestPaths, DoNotLeadFromOnePartToAnother)
{
  const EdgeGraph graph(solverMeshOf(test::merged(test::tetrahedron(), test::tetrahedron())));
  EXPECT_THAT(shortestPath(graph, 0, 5), IsEmpty());
  EXPECT_THAT(shortestPath(graph, 5, 6), ElementsAre(5, 6));
  EXPECT_THAT(shortestPath(graph, 3, 3), ElementsAre(3));
}

TEST(ShortestPaths, PassVerticesInOnePlace)
{
  Mesh mesh = test::grid(4, 1);
  mesh.positions.row(1) = mesh.positions.row(2);
  mesh.positions.row(6) = mesh.positions.row(7);
  const EdgeGraph graph(solverMeshOf(mesh));
  const Eigen::MatrixXd lengths = test::pathLengths(mesh);
  for (Index from = 0; from < mesh.vertexCount(); ++from)
    for (Index to = 0; to < mesh.vertexCount(); ++to)
      EXPECT_NEAR(lengthOf(shortestPath(graph, from, to), mesh), lengths(from, to), 1e-14);
}

TEST(ShortestPaths, AreTheSameAtEverySize)
{
  const Mesh mesh = test::plate(6, 5);
  const EdgeGraph graph(solverMeshOf(mesh));
  for (const int exponent : {-1000, -500, 500, 1000}) {
    Mesh other = mesh;
    other.positions = mesh.positions.unaryExpr([&](double x) { return std::ldexp(x, exponent); });
    const EdgeGraph otherGraph(solverMeshOf(other));
    for (Index to = 0; to < mesh.vertexCount(); ++to)
      EXPECT_EQ(shortestPath(otherGraph, 3, to), shortestPath(graph, 3, to)) << exponent;
  }
}

}  // namespace
}  // namespace holdfast
