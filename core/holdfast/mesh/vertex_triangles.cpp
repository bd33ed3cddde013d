#include "holdfast/mesh/vertex_triangles.h"

namespace holdfast {
namespace {

/// Calls `visit(vertex)` for each vertex of a triangle once, also where the triangle names it twice.
template <class Visitor>
void forEachVertex(const Triangle& triangle, Visitor&& visit)
{
  visit(triangle[0]);
  if (triangle[1] != triangle[0]) visit(triangle[1]);
  if (triangle[2] != triangle[0] && triangle[2] != triangle[1]) visit(triangle[2]);
}

}  // namespace

VertexTriangles::VertexTriangles(const std::vector<Triangle>& triangles, Index vertexCount)
    : starts_(static_cast<std::size_t>(vertexCount) + 1, 0)
{
  for (const Triangle& triangle : triangles) forEachVertex(triangle, [&](Index vertex) { ++starts_[vertex + 1]; });
  for (Index v = 0; v < vertexCount; ++v) starts_[v + 1] += starts_[v];
  triangles_.resize(static_cast<std::size_t>(starts_.back()));
  std::vector<Index> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    forEachVertex(triangles[t], [&](Index vertex) { triangles_[next[vertex]++] = static_cast<Index>(t); });
}

}  // namespace holdfast
