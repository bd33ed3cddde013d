#include "holdfast/surface/surface_locator.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <holdfast/mesh/labels.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

TrianglePoint at(const std::array<Vector3, 3>& corners, const std::array<double, 3>& weights, const Vector3& place)
{
  const Vector3 position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  return {weights, position, (position - place).squaredNorm()};
}

TrianglePoint closestOfSide(const std::array<Vector3, 3>& corners, int k, const Vector3& place)
{
  const int next = (k + 1) % 3;
  const Vector3 side = corners[next] - corners[k];
  const double squared = side.squaredNorm();
  const double t = squared > 0 ? std::clamp((place - corners[k]).dot(side) / squared, 0.0, 1.0) : 0.0;
  std::array<double, 3> weights{};
  weights[k] = 1 - t;
  weights[next] = t;
  return at(corners, weights, place);
}

// Places farther away than 2^this times the size of the surface are moved nearer: their squares would overflow, and the
// closest point is the same long before.
constexpr int kFarthestExponent = 200;

double largestCoordinate(const Positions& positions, const std::vector<Triangle>& triangles)
{
  double largest = 0;
  for (const Triangle& triangle : triangles)
    for (const Index v : triangle) largest = std::max(largest, positions.row(v).cwiseAbs().maxCoeff());
  return largest;
}

/// The exponent of the power of two just below a length; that of 1 for no length.
int exponentOf(double length)
{
  return length > 0 ? std::ilogb(length) : 0;
}

/// `lengths` times 2^exponent; powers of two round nothing.
template <class Lengths>
Lengths scaled(const Lengths& lengths, int exponent)
{
  return lengths.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
}

using Corners = std::span<const int>;

std::size_t cornerOf(Corners face, Index vertex)
{
  return static_cast<std::size_t>(std::find(face.begin(), face.end(), vertex) - face.begin());
}

/// What `location` lies on, before weights of zero are left out: an edge stays an edge at its ends.
std::vector<Term> supportOf(const SurfaceLocation& location, const SurfacePoint& point)
{
  if (const auto* edge = std::get_if<AtEdge>(&location)) return {{edge->i, edge->t}, {edge->j, 1 - edge->t}};
  return point.terms;
}

Index hostFaceOf(const SurfaceLocation& location, const std::vector<Term>& terms, const Mesh& mesh)
{
  const Polygons& faces = mesh.faces;
  if (const auto* face = std::get_if<AtFace>(&location)) return face->face;
  for (Index f = 0; f < faces.size(); ++f)
    if (faces.isSurface(f) &&
        std::ranges::all_of(terms, [&](const Term& t) { return cornerOf(faces[f], t.index) < faces[f].size(); }))
      return f;
  throw InputError({},
                   fmt::format("no face uses {}, so a point there can only be that vertex; choose another vertex first",
                               vertexText(mesh, terms.front().index)));
}

AtVertex nearestCorner(Corners face, const Vector3& place, const Positions& rest)
{
  const auto distance = [&](Index v) { return (rest.row(v).transpose() - place).stableNorm(); };
  return {*std::min_element(face.begin(), face.end(), [&](Index a, Index b) { return distance(a) < distance(b); })};
}

AtEdge nearestSide(Corners face, const Vector3& place, const Positions& rest)
{
  AtEdge nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Index i = face[k];
    const Index j = face[(k + 1) % face.size()];
    if (i == j) continue;
    const Vector3 a = rest.row(i);
    const Vector3 b = rest.row(j);
    const double length = (a - b).stableNorm();
    const double t = length > 0 ? std::clamp(((place - b) / length).dot((a - b) / length), 0.0, 1.0) : 0.0;
    const double distance = (t * a + (1 - t) * b - place).stableNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = {i, j, t};
  }
  return nearest;
}

AtEdge firstEdgeAt(Index vertex, const Mesh& mesh)
{
  const Polygons& faces = mesh.faces;
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; faces.isSurface(f) && k < faces[f].size(); ++k) {
      const Index i = faces[f][k];
      const Index j = faces[f][(k + 1) % faces[f].size()];
      if (i != j && (i == vertex || j == vertex)) return {vertex, i == vertex ? j : i, 1};
    }
  throw InputError(
      {}, fmt::format("no edge joins {} to another, so a point there cannot lie on one; choose another vertex first",
                      vertexText(mesh, vertex)));
}

AtFace inFace(Index face, Corners corners, const std::vector<Term>& terms)
{
  AtFace at{face, std::vector<double>(corners.size(), 0)};
  for (const Term& term : terms) at.weights[cornerOf(corners, term.index)] = term.coefficient;
  return at;
}

}  // namespace

TrianglePoint closestPointOfTriangle(const std::array<Vector3, 3>& corners, const Vector3& place)
{
  TrianglePoint best = closestOfSide(corners, 0, place);
  for (int k = 1; k < 3; ++k)
    if (const TrianglePoint other = closestOfSide(corners, k, place); other.squaredDistance < best.squaredDistance)
      best = other;
  const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return best;
  const double w1 = (place - corners[0]).cross(corners[2] - corners[0]).dot(normal) / squared;
  const double w2 = (corners[1] - corners[0]).cross(place - corners[0]).dot(normal) / squared;
  const double w0 = 1 - w1 - w2;
  if (w0 <= 0 || w1 <= 0 || w2 <= 0) return best;
  const TrianglePoint inside = at(corners, {w0, w1, w2}, place);
  return inside.squaredDistance < best.squaredDistance ? inside : best;
}

ClosestPointSearch::ClosestPointSearch(const Positions& positions, const std::vector<Triangle>& triangles)
    : exponent_(exponentOf(largestCoordinate(positions, triangles))),
      positions_(scaled(positions, -exponent_)),
      tree_(positions_, triangles),
      boxes_(tree_.boxesAt(positions_))
{
}

ClosestPointSearch::Result ClosestPointSearch::find(const Vector3& place) const
{
  const int exponent = std::max(exponent_, exponentOf(place.cwiseAbs().maxCoeff()) - kFarthestExponent);
  const Vector3 from = scaled(place, -exponent);
  const auto bound = [&](const Eigen::AlignedBox3d& box, double /*limit*/) {
    // A little less than it is: boxes no nearer than the best triangle are passed over, and one of them may hold an
    // equally near triangle that comes first in file order.
    return std::nextafter(box.squaredExteriorDistance(from), -1.0);
  };
  TrianglePoint best{{}, Vector3::Zero(), std::numeric_limits<double>::infinity()};
  Index nearest = std::numeric_limits<Index>::max();
  tree_.visit(boxes_, bound, best.squaredDistance, [&](Index triangle) {
    const auto& [a, b, c] = tree_.triangles()[triangle];
    const TrianglePoint candidate =
        closestPointOfTriangle({positions_.row(a), positions_.row(b), positions_.row(c)}, from);
    // Where triangles share the closest point, the first in file order is taken, whatever the order of the tree.
    if (candidate.squaredDistance < best.squaredDistance ||
        (candidate.squaredDistance == best.squaredDistance && triangle < nearest)) {
      best = candidate;
      nearest = triangle;
    }
    return false;
  });
  std::vector<Term> terms;
  terms.reserve(3);
  for (int k = 0; k < 3; ++k) terms.push_back({tree_.triangles()[nearest][k], best.weights[k]});
  return {canonical(std::move(terms)), nearest, std::ldexp(std::sqrt(best.squaredDistance), exponent)};
}

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
  if (!mesh_.faces.isSurface(face.face))
    throw InputError(below(where, ".face"),
                     fmt::format("{} has {} and is no surface; name a face of three corners or more",
                                 faceText(mesh_, face.face), counted(static_cast<Index>(corners.size()), "corner")));
  if (corners.size() != face.weights.size())
    throw InputError(
        below(where, ".weights"),
        fmt::format("{} has {} corners but {} weights are given; give one for each corner in the order of the file",
                    faceText(mesh_, face.face), corners.size(), face.weights.size()));
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
  const auto ends = [](const HalfEdge& edge) { return std::pair<Index, Index>(edge.a, edge.b); };
  return std::ranges::binary_search(index_->halfEdges(triangulation_), std::pair(std::min(i, j), std::max(i, j)), {},
                                    ends);
}

SurfaceLocation converted(const SurfaceLocation& location, LocationKind kind, const Mesh& mesh,
                          const SurfaceLocator& locator)
{
  if (kindOf(location) == kind) return location;
  const SurfacePoint point = locator.locate(location, {});
  const std::vector<Term> terms = supportOf(location, point);
  const Vector3 place = positionOf(point, mesh.positions);
  const bool isVertex = point.terms.size() == 1;
  if (kind == LocationKind::Vertex && isVertex) return AtVertex{point.terms.front().index};
  const Index f = hostFaceOf(location, terms, mesh);
  const Corners face = mesh.faces[f];
  switch (kind) {
    case LocationKind::Vertex:
      if (terms.size() > 2 || std::holds_alternative<AtFace>(location))
        return nearestCorner(face, place, mesh.positions);
      return AtVertex{terms[0].coefficient >= terms[1].coefficient ? terms[0].index : terms[1].index};
    case LocationKind::Edge:
      if (isVertex) return firstEdgeAt(point.terms.front().index, mesh);
      if (terms.size() == 2 && locator.isEdge(terms[0].index, terms[1].index))
        return AtEdge{terms[0].index, terms[1].index, terms[0].coefficient};
      return nearestSide(face, place, mesh.positions);
    case LocationKind::Face:
      return inFace(f, face, terms);
    case LocationKind::Near:
      return AtNear{place};
  }
  return location;
}

void requireVertex(Index vertexCount, Index vertex, const InputLocation& where, const std::string& key)
{
  if (vertex < 0 || vertex >= vertexCount)
    throw InputError(below(where, key), fmt::format("there is no vertex {}; the mesh has {} vertices, numbered from 0",
                                                    vertex, vertexCount));
}

void requirePlace(const std::vector<Index>& withoutPlace, Index vertex, const InputLocation& where,
                  const std::string& key)
{
  if (std::ranges::binary_search(withoutPlace, vertex))
    throw InputError(below(where, key), fmt::format("vertex {} has no place: no face uses it, and its coordinates in "
                                                    "the file are not finite numbers; name another",
                                                    vertex));
}

InputLocation below(const InputLocation& where, const std::string& key)
{
  return {where.file, where.line, where.element + key};
}

}  // namespace holdfast
