#include "holdfast/surface/location_kind.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include <fmt/format.h>

namespace holdfast {
namespace {

using Corners = std::span<const Index>;

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

Index hostFaceOf(const SurfaceLocation& location, const std::vector<Term>& terms, const Polygons& faces)
{
  if (const auto* face = std::get_if<AtFace>(&location)) return face->face;
  for (Index f = 0; f < faces.size(); ++f)
    if (std::ranges::all_of(terms, [&](const Term& t) { return cornerOf(faces[f], t.index) < faces[f].size(); }))
      return f;
  throw InputError(
      {}, fmt::format("no face uses vertex {}, so a point there can only be that vertex; choose another vertex first",
                      terms.front().index));
}

AtVertex nearestCorner(Corners face, const Vector3& place, const Positions& rest)
{
  const auto distance = [&](Index v) { return (rest.row(v).transpose() - place).stableNorm(); };
  return {*std::min_element(face.begin(), face.end(), [&](Index a, Index b) { return distance(a) < distance(b); })};
}

/// The point t a + (1 - t) b, t in [0, 1], that is closest to `place`.
double closestShare(const Vector3& a, const Vector3& b, const Vector3& place)
{
  const Vector3 side = a - b;
  const double length = side.stableNorm();
  return length > 0 ? std::clamp(((place - b) / length).dot(side / length), 0.0, 1.0) : 0.0;
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
    const double t = closestShare(a, b, place);
    const double distance = (t * a + (1 - t) * b - place).stableNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = {i, j, t};
  }
  return nearest;
}

AtEdge firstEdgeAt(Index vertex, const Polygons& faces)
{
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < faces[f].size(); ++k) {
      const Index i = faces[f][k];
      const Index j = faces[f][(k + 1) % faces[f].size()];
      if (i != j && (i == vertex || j == vertex)) return {vertex, i == vertex ? j : i, 1};
    }
  throw InputError(
      {},
      fmt::format("no edge joins vertex {} to another, so a point there cannot lie on one; choose another vertex first",
                  vertex));
}

AtFace inFace(Index face, Corners corners, const std::vector<Term>& terms)
{
  AtFace at{face, std::vector<double>(corners.size(), 0)};
  for (const Term& term : terms) at.weights[cornerOf(corners, term.index)] = term.coefficient;
  return at;
}

}  // namespace

SurfaceLocation converted(const SurfaceLocation& location, LocationKind kind, const Mesh& mesh,
                          const SurfaceLocator& locator)
{
  if (kindOf(location) == kind) return location;
  const SurfacePoint point = locator.locate(location, {});
  const std::vector<Term> terms = supportOf(location, point);
  const Vector3 place = positionOf(point, mesh.positions);
  const bool isVertex = point.terms.size() == 1;
  if (kind == LocationKind::Vertex && isVertex) return AtVertex{point.terms.front().index};
  const Index f = hostFaceOf(location, terms, mesh.faces);
  const Corners face = mesh.faces[f];
  switch (kind) {
    case LocationKind::Vertex:
      if (terms.size() > 2 || std::holds_alternative<AtFace>(location))
        return nearestCorner(face, place, mesh.positions);
      return AtVertex{terms[0].coefficient >= terms[1].coefficient ? terms[0].index : terms[1].index};
    case LocationKind::Edge:
      if (isVertex) return firstEdgeAt(point.terms.front().index, mesh.faces);
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

}  // namespace holdfast
