#include "holdfast/surface/guide_surface.h"

#include <algorithm>
#include <cmath>

#include <holdfast/mesh/edges.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

// Triangles at an angle of more than 40 degrees meet at a crease.
constexpr double kCreaseCosine = 0.766;

using CornerPlaces = std::array<Vector3, 3>;

CornerPlaces cornersOf(const Positions& positions, const Triangle& triangle)
{
  return {positions.row(triangle[0]), positions.row(triangle[1]), positions.row(triangle[2])};
}

Vector3 normalOf(const CornerPlaces& corners)
{
  return unitOrZero((corners[1] - corners[0]).cross(corners[2] - corners[0]));
}

double angleAt(const CornerPlaces& corners, std::size_t k)
{
  const Vector3 a = corners[(k + 1) % 3] - corners[k];
  const Vector3 b = corners[(k + 2) % 3] - corners[k];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Positions without those that are not finite, which no triangle uses.
Positions finite(Positions positions)
{
  for (Index v = 0; v < positions.rows(); ++v)
    if (!positions.row(v).allFinite()) positions.row(v).setZero();
  return positions;
}

std::vector<Triangle> usableTriangles(const Mesh& mesh, const Positions& positions)
{
  const std::vector<int> first = firstAtPlaces(positions);
  std::vector<Triangle> triangles;
  for (Triangle triangle : triangulate(mesh).triangles) {
    if (!std::ranges::all_of(triangle, [&](int v) { return mesh.positions.row(v).allFinite(); })) continue;
    for (int& v : triangle) v = first[v];
    if (!normalOf(cornersOf(positions, triangle)).isZero(0)) triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<Triangle> requiredTriangles(const Mesh& mesh, const Positions& positions, const std::string& source)
{
  std::vector<Triangle> triangles = usableTriangles(mesh, positions);
  if (triangles.empty())
    throw InputError({source, 0, ""}, "it has no faces with an area, so no point can lie on it; give a surface mesh");
  return triangles;
}

}  // namespace

struct GuideSurface::Parts {
  Parts(const Mesh& mesh, const std::string& source)
      : positions(finite(mesh.positions)),
        triangles(requiredTriangles(mesh, positions, source)),
        trianglesAt(trianglesOfVertices(triangles, positions.rows())),
        halfEdges(sortedHalfEdges(triangles)),
        closest(positions, triangles),
        normals(static_cast<Index>(triangles.size()), 3),
        isOnBorder(static_cast<std::size_t>(positions.rows()), false)
  {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      normals.row(static_cast<Index>(t)) = normalOf(cornersOf(positions, triangles[t]));
    forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
      if (edge.size() > 1) return;
      isOnBorder[edge.front().a] = true;
      isOnBorder[edge.front().b] = true;
    });
  }

  /// The half edges between two vertices.
  [[nodiscard]] std::span<const HalfEdge> edge(Index a, Index b) const
  {
    const auto ends = [](const HalfEdge& half) { return std::pair<Index, Index>(half.a, half.b); };
    return std::ranges::equal_range(halfEdges, std::pair(std::min(a, b), std::max(a, b)), {}, ends);
  }

  /// The sum of the normals at a vertex, by their angles there, of the triangles that `isPart` picks.
  template <class Predicate>
  [[nodiscard]] Vector3 normalAt(Index vertex, const Predicate& isPart) const
  {
    Vector3 sum = Vector3::Zero();
    for (const Index t : trianglesAt[vertex]) {
      const Triangle& triangle = triangles[t];
      const auto corner = static_cast<std::size_t>(std::ranges::find(triangle, vertex) - triangle.begin());
      if (isPart(t)) sum += angleAt(cornersOf(positions, triangle), corner) * normals.row(t).transpose();
    }
    return sum;
  }

  /// Tells on which side of a vertex a place lies (Baerentzen and Aanaes, 2005).
  [[nodiscard]] Vector3 outwardsAt(Index vertex) const
  {
    return normalAt(vertex, [](Index /*triangle*/) { return true; });
  }

  /// The normal between those at the corners of the triangle that was found. Triangles beyond a crease do not count.
  [[nodiscard]] Vector3 smoothNormal(const ClosestPointSearch::Result& found) const
  {
    const Vector3 own = normals.row(found.triangle);
    Vector3 sum = Vector3::Zero();
    for (const Term& term : found.point.terms)
      sum += term.coefficient *
             unitOrZero(normalAt(term.index, [&](Index t) { return own.dot(normals.row(t)) > kCreaseCosine; }));
    return sum.normalized();
  }

  Positions positions;
  std::vector<Triangle> triangles;
  IndexLists trianglesAt;  // vertices
  std::vector<HalfEdge> halfEdges;
  ClosestPointSearch closest;
  Positions normals;  // of triangles
  std::vector<bool> isOnBorder;
};

GuideSurface::GuideSurface(const Mesh& mesh, const std::string& source)
    : parts_(std::make_unique<const Parts>(mesh, source))
{
}

GuideSurface::~GuideSurface() = default;

const Positions& GuideSurface::positions() const noexcept
{
  return parts_->positions;
}

const std::vector<Triangle>& GuideSurface::triangles() const noexcept
{
  return parts_->triangles;
}

Foot GuideSurface::footOf(const Vector3& place) const
{
  const ClosestPointSearch::Result found = parts_->closest.find(place);
  const std::vector<Term>& terms = found.point.terms;
  Foot foot{positionOf(found.point, parts_->positions), parts_->smoothNormal(found), found.distance, false};
  Vector3 outwards = parts_->normals.row(found.triangle);
  if (terms.size() == 2) {
    const std::span<const HalfEdge> edge = parts_->edge(terms[0].index, terms[1].index);
    foot.isOnBorder = edge.size() == 1;
    outwards.setZero();
    for (const HalfEdge& half : edge) outwards += parts_->normals.row(half.triangle);
  } else if (terms.size() == 1) {
    foot.isOnBorder = parts_->isOnBorder[terms[0].index];
    outwards = parts_->outwardsAt(terms[0].index);
  }
  if ((place - foot.place).dot(outwards) < 0) foot.distance = -foot.distance;
  return foot;
}

}  // namespace holdfast
