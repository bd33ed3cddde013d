#include "holdfast/widgets/picking/surface_picker.h"

namespace holdfast {
namespace {

struct PointOfEdge {
  double share = 0;  ///< the place is a + share (b - a), in [0, 1]
  Vector3 place = Vector3::Zero();
  double distance = 0;  ///< on the screen, pixels
};

// An edge that passes the eye is looked at from this share of its farther end's depth onwards.
constexpr double kLeastDepth = 1e-6;

/// The share of the segment that is at least as deep as that.
RayRange inFrontOfEye(double depthA, double depthB)
{
  const double least = kLeastDepth * std::max(depthA, depthB);
  const double share = (least - depthA) / (depthB - depthA);
  if (depthA < least) return {share, 1};
  if (depthB < least) return {0, share};
  return {0, 1};
}

/// The point of the segment from `a` to `b` that is shown nearest to `point`; none where all of it is behind the eye.
std::optional<PointOfEdge> nearestOfEdge(const Vector3& a, const Vector3& b, const DisplayPoint& point,
                                         const DisplayTransform& display)
{
  const double depthA = display.show(a).depth;
  const double depthB = display.show(b).depth;
  if (!(std::max(depthA, depthB) > 0)) return std::nullopt;
  const auto [begin, end] = inFrontOfEye(depthA, depthB);
  const auto placeAt = [&](double share) -> Vector3 { return (1 - share) * a + share * b; };
  const DisplayTransform::Shown low = display.show(placeAt(begin));
  const DisplayTransform::Shown high = display.show(placeAt(end));
  const DisplayPoint along = high.point - low.point;
  const double squared = along.squaredNorm();
  const double s = squared > 0 ? std::clamp((point - low.point).dot(along) / squared, 0.0, 1.0) : 0.0;
  // Equal steps on the screen are longer ones along the edge where it is farther away.
  const double inRange = s * low.size / ((1 - s) * high.size + s * low.size);
  const double share = std::clamp(begin + inRange * (end - begin), 0.0, 1.0);
  return PointOfEdge{share, placeAt(share), (low.point + s * along - point).norm()};
}

constexpr double kAnyDistance = std::numeric_limits<double>::infinity();

/// One search around one cursor.
class Search {
 public:
  Search(const VisibleSurface& surface, const DisplayTransform& display, const DisplayPoint& cursor)
      : model_(surface.model()),
        surface_(surface),
        display_(display),
        cursor_(cursor),
        hit_(surface.firstHit(display.rayThrough(cursor)))
  {
  }

  [[nodiscard]] bool hitsSurface() const { return hit_.has_value(); }

  /// Returns the triangles of the face under the cursor and of all that share a vertex with it.
  [[nodiscard]] std::vector<Index> trianglesAround() const
  {
    const std::vector<int>& faceOf = model_.triangulation.faceOf;
    std::vector<Index> faces;
    for (const Index vertex : model_.mesh.faces[faceOf[hit_->triangle]])
      for (const Index triangle : surface_.trianglesAt(vertex))
        if (!surface_.isHidden(triangle)) faces.push_back(faceOf[triangle]);
    std::vector<Index> triangles;
    for (const Index face : sortedOnce(std::move(faces))) {
      const auto [first, last] = std::equal_range(faceOf.begin(), faceOf.end(), face);
      for (auto t = first; t != last; ++t) triangles.push_back(t - faceOf.begin());
    }
    return triangles;
  }

  [[nodiscard]] SurfacePick ofFace() const
  {
    const Index face = model_.triangulation.faceOf[hit_->triangle];
    const auto corners = model_.mesh.faces[face];
    AtFace at{face, std::vector<double>(corners.size(), 0.0)};
    Vector3 place = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index corner = model_.triangulation.cornersOf(hit_->triangle)[k];
      at.weights[corner] = hit_->weights[k];
      place += hit_->weights[k] * surface_.positions().row(corners[corner]).transpose();
    }
    return {std::move(at), place, face, hit_->triangle};
  }

  /// The nearest visible vertex, or point of an edge, of `triangles` up to `reach` pixels away.
  [[nodiscard]] std::optional<SurfacePick> vertexOf(const std::vector<Index>& triangles, double reach) const
  {
    for (const auto& [distance, vertex] : verticesByDistance(triangles, reach))
      if (surface_.isVertexVisible(vertex, display_))
        return pickOf(AtVertex{vertex}, surface_.positions().row(vertex), vertex, vertex);
    return std::nullopt;
  }

  [[nodiscard]] std::optional<SurfacePick> edgeOf(const std::vector<Index>& triangles, double reach) const
  {
    for (const auto& [point, i, j] : edgesByDistance(triangles, reach)) {
      if (!surface_.isEdgeVisible(i, j, point.place, display_)) continue;
      const double t = 1 - point.share;
      return pickOf(AtEdge{i, j, t}, t * surface_.positions().row(i) + (1 - t) * surface_.positions().row(j), i, j);
    }
    return std::nullopt;
  }

 private:
  struct ShownVertex {
    double distance = 0;
    Index vertex = 0;
  };
  struct ShownEdge {
    PointOfEdge point;
    Index i = 0;
    Index j = 0;
  };

  [[nodiscard]] std::vector<ShownVertex> verticesByDistance(const std::vector<Index>& triangles, double reach) const
  {
    std::vector<Index> vertices;
    for (const Index t : triangles)
      for (const Index vertex : model_.triangulation.triangles[t]) vertices.push_back(vertex);
    std::vector<ShownVertex> found;
    for (const Index vertex : sortedOnce(std::move(vertices))) {
      const DisplayTransform::Shown shown = display_.show(surface_.positions().row(vertex));
      if (!(shown.depth > 0)) continue;
      const double distance = (shown.point - cursor_).norm();
      if (distance <= reach) found.push_back({distance, vertex});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const ShownVertex& a, const ShownVertex& b) { return a.distance < b.distance; });
    return found;
  }

  [[nodiscard]] std::vector<ShownEdge> edgesByDistance(const std::vector<Index>& triangles, double reach) const
  {
    std::vector<ShownEdge> found;
    for (const auto& [i, j] : sidesOfFaces(triangles)) {
      const Vector3 a = surface_.positions().row(i);
      const Vector3 b = surface_.positions().row(j);
      const auto placeAt = [&](double share) -> Vector3 { return (1 - share) * a + share * b; };
      const auto [begin, end] = surface_.keptPart({a, b - a}, {0, 1});
      if (begin > end) continue;
      auto point = nearestOfEdge(placeAt(begin), placeAt(end), cursor_, display_);
      if (!point || point->distance > reach) continue;
      point->share = begin + point->share * (end - begin);
      found.push_back({*point, i, j});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const ShownEdge& a, const ShownEdge& b) { return a.point.distance < b.point.distance; });
    return found;
  }

  /// Each once, its smaller vertex first; ascending.
  [[nodiscard]] std::vector<std::pair<Index, Index>> sidesOfFaces(const std::vector<Index>& triangles) const
  {
    std::vector<std::pair<Index, Index>> sides;
    for (const Index t : triangles)
      for (int side = 0; side < 3; ++side) {
        const Triangle& corners = model_.triangulation.triangles[t];
        const std::pair<Index, Index> ends = std::minmax(corners[side], corners[(side + 1) % 3]);
        if (ends.first != ends.second && isSideOfFace(t, side)) sides.push_back(ends);
      }
    return sortedOnce(std::move(sides));
  }

  /// Tells whether the side is one of the face that the triangle is cut from, not a cut.
  [[nodiscard]] bool isSideOfFace(Index triangle, int side) const
  {
    const auto corners = model_.triangulation.cornersOf(triangle);
    const auto count = static_cast<Index>(model_.mesh.faces[model_.triangulation.faceOf[triangle]].size());
    const Index a = corners[side];
    const Index b = corners[(side + 1) % 3];
    return (a + 1) % count == b || (b + 1) % count == a;
  }

  /// A triangle with both vertices: that under the cursor, or else one of the same face, or else the first.
  [[nodiscard]] Index triangleWith(Index i, Index j) const
  {
    const std::vector<int>& faceOf = model_.triangulation.faceOf;
    const auto rank = [&](Index t) {
      if (!hit_) return 2;
      return t == hit_->triangle ? 0 : faceOf[t] == faceOf[hit_->triangle] ? 1 : 2;
    };
    Index best = -1;
    for (const Index t : surface_.trianglesAt(i)) {
      const Triangle& own = model_.triangulation.triangles[t];
      if (surface_.isHidden(t)) continue;
      if (std::count(own.begin(), own.end(), i) == 0 || std::count(own.begin(), own.end(), j) == 0) continue;
      if (best < 0 || rank(t) < rank(best)) best = t;
    }
    return best;
  }

  [[nodiscard]] SurfacePick pickOf(SurfaceLocation location, const Vector3& place, Index i, Index j) const
  {
    const Index triangle = triangleWith(i, j);
    return {std::move(location), place, model_.triangulation.faceOf[triangle], triangle};
  }

  const Model& model_;
  const VisibleSurface& surface_;
  const DisplayTransform& display_;
  DisplayPoint cursor_;
  std::optional<RayHit> hit_;
};

}  // namespace

SurfacePoint pointOf(const SurfaceLocation& location, const Mesh& mesh)
{
  if (const auto* vertex = std::get_if<AtVertex>(&location)) return canonical({{vertex->vertex, 1}});
  if (const auto* edge = std::get_if<AtEdge>(&location)) return canonical({{edge->i, edge->t}, {edge->j, 1 - edge->t}});
  const auto& [face, weights] = std::get<AtFace>(location);
  std::vector<Term> terms;
  for (std::size_t k = 0; k < weights.size(); ++k) terms.push_back({mesh.faces[face][k], weights[k]});
  return canonical(std::move(terms));
}

std::optional<SurfacePick> SurfacePicker::pick(vtkRenderer& renderer, double displayX, double displayY, PickKind kind,
                                               double snapPixels) const
{
  const DisplayTransform display(renderer);
  const DisplayPoint cursor = centerOfPixel(displayX, displayY);
  const Search search(*surface_, display, cursor);
  if (kind != PickKind::Face) {
    const std::vector<Index> triangles = surface_->withinReach(display.rayThrough(cursor), display.reachOf(snapPixels));
    if (kind != PickKind::Edge)
      if (auto vertex = search.vertexOf(triangles, snapPixels)) return vertex;
    if (kind != PickKind::Vertex)
      if (auto edge = search.edgeOf(triangles, snapPixels)) return edge;
  }
  if (!search.hitsSurface()) return std::nullopt;
  if (kind == PickKind::Vertex) return search.vertexOf(search.trianglesAround(), kAnyDistance);
  if (kind == PickKind::Edge) return search.edgeOf(search.trianglesAround(), kAnyDistance);
  return search.ofFace();
}

}  // namespace holdfast
