#include "holdfast/surface/surface_locator.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace holdfast {

const ClosestPointSearch& SurfaceIndex::closest(const Mesh& mesh, const Triangulation& triangulation)
{
  std::call_once(hasClosest_, [&] { closest_.emplace(mesh.positions, triangulation.triangles); });
  return *closest_;
}

const std::vector<HalfEdge>& SurfaceIndex::halfEdges(const Triangulation& triangulation)
{
  std::call_once(hasHalfEdges_, [&] { halfEdges_ = sortedHalfEdges(triangulation.triangles); });
  return halfEdges_;
}

SurfacePoint SurfaceLocator::locate(const SurfaceLocation& location, const InputLocation& where) const
{
  return std::visit([&](const auto& named) { return at(named, where); }, location);
}

SurfacePoint SurfaceLocator::at(const AtVertex& vertex, const InputLocation& where) const
{
  requireVertex(mesh_.vertexCount(), vertex.vertex, where, ".vertex");
  return {{{vertex.vertex, 1.0}}};
}

SurfacePoint SurfaceLocator::at(const AtEdge& edge, const InputLocation& where) const
{
  requireVertex(mesh_.vertexCount(), edge.i, where, ".edge[0]");
  requireVertex(mesh_.vertexCount(), edge.j, where, ".edge[1]");
  if (!isEdge(edge.i, edge.j))
    throw InputError(below(where, ".edge"), fmt::format("no face has an edge between the vertices {} and {}; name the "
                                                        "ends of one edge, or give the place as \"near\"",
                                                        edge.i, edge.j));
  return canonical({{edge.i, edge.t}, {edge.j, 1 - edge.t}});
}

SurfacePoint SurfaceLocator::at(const AtFace& face, const InputLocation& where) const
{
  if (face.face < 0 || face.face >= mesh_.faces.size())
    throw InputError(below(where, ".face"), fmt::format("there is no face {}; the mesh has {} faces, numbered from 0",
                                                        face.face, mesh_.faces.size()));
  const auto corners = mesh_.faces[face.face];
  if (corners.size() != face.weights.size())
    throw InputError(
        below(where, ".weights"),
        fmt::format(
            "face {} has {} corners but {} weights are given; give one for each corner in the order of the file",
            face.face, corners.size(), face.weights.size()));
  std::vector<Term> terms;
  for (std::size_t k = 0; k < corners.size(); ++k) terms.push_back({corners[k], face.weights[k]});
  return canonical(std::move(terms));
}

SurfacePoint SurfaceLocator::at(const AtNear& near, const InputLocation& /*where*/) const
{
  return closestTo(near.place).point;
}

bool SurfaceLocator::isEdge(Index i, Index j) const
{
  const std::vector<HalfEdge>& halfEdges = index_->halfEdges(triangulation_);
  const std::pair<Index, Index> key = std::minmax(i, j);
  const auto ends = [](const HalfEdge& edge) { return std::pair(edge.a, edge.b); };
  const auto found = std::lower_bound(
      halfEdges.begin(), halfEdges.end(), key,
      [&](const HalfEdge& edge, const std::pair<Index, Index>& wanted) { return ends(edge) < wanted; });
  return found != halfEdges.end() && ends(*found) == key;
}

void requireVertex(Index vertexCount, Index vertex, const InputLocation& where, const std::string& key)
{
  if (vertex < 0 || vertex >= vertexCount)
    throw InputError(below(where, key), fmt::format("there is no vertex {}; the mesh has {} vertices, numbered from 0",
                                                    vertex, vertexCount));
}

InputLocation below(const InputLocation& where, const std::string& key)
{
  return {where.file, where.line, where.element + key};
}

}  // namespace holdfast
