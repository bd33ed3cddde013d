#include "holdfast/surface/vertex_regions.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include <holdfast/mesh/edges.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

// Normals of needles in one plane differ by rounding.
constexpr double kAngleSlack = 1e-6;

// The cosine of 0.003 degrees: coordinates of nine digits bend planes by less.
constexpr double kFlatCosine = 1 - 1e-9;

double angleDegrees(const Vector3& a, const Vector3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

std::vector<Index> VertexRegions::connected(std::span<const Index> vertices) const
{
  const std::vector<int>& partOf = solverMesh_.componentOf;
  std::vector<bool> isChosen = unknownsOf(vertices);
  std::vector<bool> isPart(static_cast<std::size_t>(solverMesh_.componentCount), false);
  for (std::size_t k = 0; k < partOf.size(); ++k)
    if (isChosen[k] && partOf[k] >= 0) isPart[partOf[k]] = true;
  for (std::size_t k = 0; k < partOf.size(); ++k) isChosen[k] = isChosen[k] || (partOf[k] >= 0 && isPart[partOf[k]]);
  return verticesWhere(isChosen);
}

std::vector<Index> VertexRegions::smooth(Index face, double degrees, BendFrom from) const
{
  std::vector<bool> isChosen = unknownsOf({});
  for (const Index reached : smoothFaces_.around(face, degrees, from))
    for (const Index vertex : mesh_.faces[reached]) isChosen[solverMesh_.weld.unknownOf[vertex]] = true;
  return verticesWhere(isChosen);
}

std::vector<Index> VertexRegions::grown(std::span<const Index> vertices) const
{
  const std::vector<bool> isGiven = unknownsOf(vertices);
  std::vector<bool> isChosen = isGiven;
  for (Index u = 0; u < graph_.vertexCount(); ++u)
    if (isGiven[u])
      for (const Index neighbour : graph_.neighbours(u)) isChosen[neighbour] = true;
  return verticesWhere(isChosen);
}

std::vector<Index> VertexRegions::shrunk(std::span<const Index> vertices) const
{
  const std::vector<bool> isGiven = unknownsOf(vertices);
  std::vector<bool> isChosen = isGiven;
  for (Index u = 0; u < graph_.vertexCount(); ++u)
    for (const Index neighbour : graph_.neighbours(u))
      if (!isGiven[neighbour]) isChosen[u] = false;
  return verticesWhere(isChosen);
}

std::vector<Index> VertexRegions::inverted(std::span<const Index> vertices) const
{
  std::vector<bool> isChosen = unknownsOf(vertices);
  for (std::size_t u = 0; u < isChosen.size(); ++u) isChosen[u] = !isChosen[u] && solverMesh_.componentOf[u] >= 0;
  return verticesWhere(isChosen);
}

std::vector<Index> VertexRegions::within(double radius, const Vector3& place, Index face,
                                         const Positions& positions) const
{
  std::vector<bool> isReached = unknownsOf({});
  std::vector<Index> queue;
  const auto reach = [&](Index unknown) {
    const Index vertex = solverMesh_.weld.firstVertexOf[unknown];
    // A ball is convex: with both of its ends an edge lies within.
    if (isReached[unknown] || (positions.row(vertex).transpose() - place).stableNorm() > radius) return;
    isReached[unknown] = true;
    queue.push_back(unknown);
  };
  for (const Index corner : mesh_.faces[face]) reach(solverMesh_.weld.unknownOf[corner]);
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const Index neighbour : graph_.neighbours(queue[next])) reach(neighbour);
  return verticesWhere(isReached);
}

std::vector<bool> VertexRegions::unknownsOf(std::span<const Index> vertices) const
{
  std::vector<bool> isGiven(static_cast<std::size_t>(solverMesh_.unknownCount()), false);
  for (const Index vertex : vertices) isGiven[solverMesh_.weld.unknownOf[vertex]] = true;
  return isGiven;
}

std::vector<Index> VertexRegions::verticesWhere(const std::vector<bool>& isChosen) const
{
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh_.vertexCount(); ++v)
    if (isChosen[solverMesh_.weld.unknownOf[v]]) vertices.push_back(v);
  return vertices;
}

RegionSize sizeOfRegion(std::span<const Index> vertices, const std::vector<Triangle>& triangles,
                        const Positions& positions)
{
  RegionSize size;
  std::vector<bool> isIn(static_cast<std::size_t>(positions.rows()), false);
  for (const Index v : vertices) {
    isIn[v] = true;
    size.box.extend(Vector3(positions.row(v)));
  }
  for (const auto& [a, b, c] : triangles) {
    if (!isIn[a] || !isIn[b] || !isIn[c]) continue;
    const Vector3 at = positions.row(a);
    const Vector3 ab = Vector3(positions.row(b)) - at;
    ++size.triangles;
    size.area += ab.cross(Vector3(positions.row(c)) - at).norm() / 2;
  }
  return size;
}

SmoothFaces::SmoothFaces(const Mesh& mesh, const SolverMesh& solverMesh)
    : mesh_(solverMesh), beyond_(solverMesh.triangles.size()), normals_(mesh.faces.size(), 3)
{
  forEachEdge(sortedHalfEdges(solverMesh.triangles), [&](std::span<const HalfEdge> halves) {
    if (halves.size() != 2) return;
    const bool isFlipped = halves[0].isForward == halves[1].isForward;
    beyond_[halves[0].triangle][halves[0].side] = {halves[1].triangle, isFlipped};
    beyond_[halves[1].triangle][halves[1].side] = {halves[0].triangle, isFlipped};
  });
  for (Index f = 0; f < mesh.faces.size(); ++f) normals_.row(f) = unitOrZero(areaVector(mesh.positions, mesh.faces[f]));
}

double SmoothFaces::flatShare() const
{
  Index flat = 0;
  Index all = 0;
  for (std::size_t triangle = 0; triangle < beyond_.size(); ++triangle)
    for (const Beyond& beyond : beyond_[triangle]) {
      if (beyond.triangle < 0) continue;
      const Vector3 here = normals_.row(mesh_.faceOf[triangle]);
      const double cosine = here.dot(Vector3(normals_.row(mesh_.faceOf[beyond.triangle])));
      ++all;
      if ((beyond.isFlipped ? -cosine : cosine) > kFlatCosine) ++flat;
    }
  return all == 0 ? 0 : static_cast<double>(flat) / static_cast<double>(all);
}

std::vector<Index> SmoothFaces::around(Index face, double degrees, BendFrom from) const
{
  std::vector<Index> queue = trianglesOf(face);
  std::vector<bool> isReached(beyond_.size(), false);
  for (const Index triangle : queue) isReached[triangle] = true;
  // With what the faces beyond each triangle in the queue are compared. A face without an area has the normal of its
  // predecessor.
  std::vector<Vector3> normals(queue.size(), normals_.row(face));
  std::vector<Index> faces{face};
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const Beyond& beyond : beyond_[queue[next]]) {
      if (beyond.triangle < 0 || isReached[beyond.triangle]) continue;
      const Index other = mesh_.faceOf[beyond.triangle];
      const Vector3 here = beyond.isFlipped ? Vector3(-normals[next]) : normals[next];
      const Vector3 own = normals_.row(other);
      const Vector3 there = own.isZero(0) ? here : own;
      if (angleDegrees(here, there) > degrees + kAngleSlack) continue;
      faces.push_back(other);
      for (const Index triangle : trianglesOf(other)) {
        isReached[triangle] = true;
        queue.push_back(triangle);
        normals.push_back(from == BendFrom::FirstFace && !here.isZero(0) ? here : there);
      }
    }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The triangles of one face are side by side.
std::vector<Index> SmoothFaces::trianglesOf(Index face) const
{
  const auto [first, last] = std::equal_range(mesh_.faceOf.begin(), mesh_.faceOf.end(), face);
  std::vector<Index> triangles(static_cast<std::size_t>(last - first));
  std::iota(triangles.begin(), triangles.end(), first - mesh_.faceOf.begin());
  return triangles;
}

}  // namespace holdfast
