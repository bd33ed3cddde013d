#include "remesh.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace holdfast::generate {
namespace {

constexpr int kRounds = 12;
constexpr int kFinalRounds = 15;
// Halves of a split edge and the sum of a collapsed one are then about as far from the wanted length as before.
constexpr double kLong = 4.0 / 3, kShort = 4.0 / 5;

class Remesher {
 public:
  Remesher(const GroupedMesh& mesh, const DistanceFunction& distance, const std::function<double(const Vector3&)>& size)
      : distance_(distance),
        size_(size),
        points_(mesh.points),
        edges_(mesh.triangles, static_cast<Index>(mesh.points.size()))
  {
  }

  GroupedMesh run()
  {
    for (int round = 0; round < kRounds; ++round) {
      splitLong();
      collapseShort();
      flipWhere(&Remesher::evensValences);
      relax();
    }
    for (int round = 0; round < kFinalRounds; ++round) {
      flipWhere(&Remesher::opensSmallestAngle);
      relax();
    }
    return extract();
  }

 private:
  [[nodiscard]] const Vector3& at(Index vertex) const { return points_[vertex]; }

  // The length of an edge relative to what is wanted there.
  [[nodiscard]] double relativeLength(const Vector3& a, const Vector3& b) const
  {
    return (b - a).norm() / size_((a + b) / 2);
  }
  [[nodiscard]] double relativeLength(Index halfEdge) const
  {
    return relativeLength(at(edges_.origin(halfEdge)), at(edges_.target(halfEdge)));
  }

  [[nodiscard]] std::vector<Index> halfEdgesByLength() const
  {
    std::vector<std::pair<double, Index>> order;
    for (Index h = 0; h < edges_.halfEdgeCount(); ++h) {
      if (!edges_.isRemoved(h) && h < edges_.twin(h)) order.emplace_back(relativeLength(h), h);
    }
    std::ranges::sort(order);
    std::vector<Index> result;
    for (const auto& [length, h] : order) result.push_back(h);
    return result;
  }

  void splitLong()
  {
    std::vector<Index> order = halfEdgesByLength();
    std::ranges::reverse(order);
    for (const Index h : order) {
      if (relativeLength(h) <= kLong) continue;
      points_.push_back(projected(distance_, (at(edges_.origin(h)) + at(edges_.target(h))) / 2));
      edges_.splitEdge(h, edges_.addVertex());
    }
  }

  void collapseShort()
  {
    for (const Index h : halfEdgesByLength()) {
      if (edges_.isRemoved(h) || relativeLength(h) >= kShort || !edges_.canCollapse(h)) continue;
      const Vector3 place = projected(distance_, (at(edges_.origin(h)) + at(edges_.target(h))) / 2);
      if (!keepsShape(h, place) || !keepsShape(edges_.twin(h), place)) continue;
      points_[edges_.origin(h)] = place;
      edges_.collapse(h);
    }
  }

  // Whether the faces around the target of `halfEdge`, save the two that vanish, neither turn nor grow much when it
  // moves to `place`.
  [[nodiscard]] bool keepsShape(Index halfEdge, const Vector3& place) const
  {
    constexpr double kSmallestCosine = 0.5;
    for (const Index h : edges_.outgoing(edges_.target(halfEdge))) {
      if (h / 3 == halfEdge / 3 || h / 3 == edges_.twin(halfEdge) / 3) continue;
      const Vector3 &b = at(edges_.target(h)), &c = at(edges_.apex(h));
      const Vector3 before = (b - at(edges_.origin(h))).cross(c - at(edges_.origin(h))).normalized();
      const Vector3 after = (b - place).cross(c - place).normalized();
      if (before.dot(after) < kSmallestCosine || relativeLength(place, b) > kLong) return false;
    }
    return true;
  }

  void flipWhere(bool (Remesher::*isBetter)(Index) const)
  {
    for (Index h = 0; h < edges_.halfEdgeCount(); ++h) {
      if (edges_.isRemoved(h) || h > edges_.twin(h)) continue;
      if ((this->*isBetter)(h) && isFlippable(h)) edges_.flip(h);
    }
  }

  // Whether the flipped edge is new, and its two faces look the same way as those of now.
  [[nodiscard]] bool isFlippable(Index h) const
  {
    const Index a = edges_.origin(h), b = edges_.target(h), c = edges_.apex(h), d = edges_.apex(edges_.twin(h));
    for (const Index other : edges_.outgoing(c)) {
      if (edges_.target(other) == d) return false;
    }
    if (valence(a) <= 4 || valence(b) <= 4) return false;
    const Vector3 normal = areaVector(a, b, c) + areaVector(b, a, d);
    return areaVector(a, d, c).dot(normal) > 0 && areaVector(d, b, c).dot(normal) > 0;
  }

  [[nodiscard]] Vector3 areaVector(Index a, Index b, Index c) const { return (at(b) - at(a)).cross(at(c) - at(a)); }
  [[nodiscard]] Index valence(Index vertex) const { return static_cast<Index>(edges_.outgoing(vertex).size()); }

  [[nodiscard]] bool evensValences(Index h) const
  {
    const auto excess = [&](Index vertex, Index change) { return std::abs(valence(vertex) + change - 6); };
    const Index a = edges_.origin(h), b = edges_.target(h), c = edges_.apex(h), d = edges_.apex(edges_.twin(h));
    const auto total = [&](Index change) {
      return excess(a, -change) + excess(b, -change) + excess(c, change) + excess(d, change);
    };
    return total(1) < total(0) && smallestAngle(a, d, c) > kHalfOpen && smallestAngle(d, b, c) > kHalfOpen;
  }

  [[nodiscard]] bool opensSmallestAngle(Index h) const
  {
    // A flip for a gain within rounding could be undone by the next one for ever.
    constexpr double kGain = 1e-9;
    const Index a = edges_.origin(h), b = edges_.target(h), c = edges_.apex(h), d = edges_.apex(edges_.twin(h));
    const double now = std::min(smallestAngle(a, b, c), smallestAngle(b, a, d));
    return std::min(smallestAngle(a, d, c), smallestAngle(d, b, c)) > now + kGain;
  }

  [[nodiscard]] double smallestAngle(Index a, Index b, Index c) const
  {
    const auto angle = [&](Index p, Index q, Index r) {
      const Vector3 u = at(q) - at(p), v = at(r) - at(p);
      return std::atan2(u.cross(v).norm(), u.dot(v));
    };
    return std::min({angle(a, b, c), angle(b, c, a), angle(c, a, b)});
  }

  // Every vertex to the middle of the triangles around it, those where small ones are wanted weighing more, and back
  // to the surface.
  void relax()
  {
    std::vector<Vector3> places = points_;
    for (Index vertex = 0; vertex < edges_.vertexCount(); ++vertex) {
      const std::vector<Index> ring = edges_.outgoing(vertex);
      if (!ring.empty()) places[vertex] = projected(distance_, centreOf(ring, vertex));
    }
    points_ = places;
  }

  [[nodiscard]] Vector3 centreOf(const std::vector<Index>& ring, Index vertex) const
  {
    Vector3 sum = Vector3::Zero();
    double weights = 0;
    for (const Index h : ring) {
      const Vector3 middle = (at(vertex) + at(edges_.target(h)) + at(edges_.apex(h))) / 3;
      const double wanted = size_(middle);
      const double weight = areaVector(vertex, edges_.target(h), edges_.apex(h)).norm() / (wanted * wanted);
      sum += weight * middle;
      weights += weight;
    }
    const Vector3 normal = gradient(distance_, at(vertex)).normalized();
    const Vector3 shift = sum / weights - at(vertex);
    return at(vertex) + shift - shift.dot(normal) * normal;
  }

  [[nodiscard]] GroupedMesh extract() const
  {
    GroupedMesh result;
    std::vector<Index> idOf(points_.size(), HalfEdges::kNone);
    for (Index face = 0; face < edges_.faceCount(); ++face) {
      if (edges_.isRemoved(3 * face)) continue;
      Triangle triangle = edges_.corners(face);
      for (Index& corner : triangle) {
        if (idOf[corner] == HalfEdges::kNone) {
          idOf[corner] = static_cast<Index>(result.points.size());
          result.points.push_back(at(corner));
        }
        corner = idOf[corner];
      }
      result.triangles.push_back(triangle);
    }
    return result;
  }

  static constexpr double kHalfOpen = 0.3;  // radians; flips for valence alone leave no angle smaller

  const DistanceFunction& distance_;
  const std::function<double(const Vector3&)>& size_;
  std::vector<Vector3> points_;
  HalfEdges edges_;
};

}  // namespace

GroupedMesh remeshed(const GroupedMesh& mesh, const DistanceFunction& distance,
                     const std::function<double(const Vector3&)>& size)
{
  return Remesher(mesh, distance, size).run();
}

}  // namespace holdfast::generate
