#include "region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace holdfast::generate {
namespace {

// A triangle whose circumradius is at most this many times that of the wanted equilateral one is left alone.
constexpr double kLargeEnough = 1.35;
// Points are kept this share of the wanted edge length away from one another.
constexpr double kClearance = 0.65;
constexpr int kSmoothingSteps = 60;

/// Grows a front of well-shaped triangles from the boundary inwards.
class Front {
 public:
  Front(Delaunay& mesh, const SizeFunction& size) : mesh_(mesh), size_(size) {}

  void fill()
  {
    for (Index base = nextBase(); base != HalfEdges::kNone; base = nextBase()) advance(base);
  }

 private:
  /// How large a face is, remembered until its corners change.
  struct Excess {
    Triangle corners{-1, -1, -1};
    double ratio = 0;        // circumradius over that of the wanted equilateral triangle
    bool isGivenUp = false;  // no point can be added without crowding others
  };

  const Excess& excess(Index face)
  {
    if (static_cast<Index>(excess_.size()) <= face) excess_.resize(mesh_.edges().faceCount());
    Excess& result = excess_[face];
    const Triangle corners = mesh_.edges().corners(face);
    if (result.corners == corners) return result;
    const auto& p = mesh_.points();
    const Vector2 centre = circumcentre(p[corners[0]], p[corners[1]], p[corners[2]]);
    const Vector2 middle = (p[corners[0]] + p[corners[1]] + p[corners[2]]) / 3;
    result = {corners, (centre - p[corners[0]]).norm() * std::numbers::sqrt3 / size_(middle), false};
    return result;
  }

  bool isDone(Index face) { return excess(face).ratio <= kLargeEnough || excess(face).isGivenUp; }

  bool isFront(Index halfEdge)
  {
    const Index neighbour = mesh_.edges().twin(halfEdge) / 3;
    return mesh_.isBoundary(halfEdge) || isDone(neighbour);
  }

  // The shortest front edge of the largest face that has one.
  Index nextBase()
  {
    Index best = HalfEdges::kNone;
    double largest = 0;
    for (Index face = 0; face < mesh_.edges().faceCount(); ++face) {
      if (!mesh_.isInside(face) || isDone(face) || excess(face).ratio <= largest) continue;
      const Index base = shortestFrontEdge(face);
      if (base == HalfEdges::kNone) continue;
      best = base;
      largest = excess(face).ratio;
    }
    return best;
  }

  Index shortestFrontEdge(Index face)
  {
    Index best = HalfEdges::kNone;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (isFront(h) && (best == HalfEdges::kNone || length(h) < length(best))) best = h;
    }
    return best;
  }

  [[nodiscard]] double length(Index halfEdge) const
  {
    const HalfEdges& edges = mesh_.edges();
    return (mesh_.points()[edges.target(halfEdge)] - mesh_.points()[edges.origin(halfEdge)]).norm();
  }

  void advance(Index base)
  {
    const Vector2 place = idealApex(base);
    const Index holder = mesh_.locate(place);
    if (holder == HalfEdges::kNone || isCrowded(place)) {
      excess_[base / 3].isGivenUp = true;
      return;
    }
    mesh_.insert(place);
  }

  // On the bisector of the base, where the circumradius becomes the wanted one, but not beyond the circumcentre.
  [[nodiscard]] Vector2 idealApex(Index base) const
  {
    const HalfEdges& edges = mesh_.edges();
    const Vector2& a = mesh_.points()[edges.origin(base)];
    const Vector2& b = mesh_.points()[edges.target(base)];
    const Vector2 centre = circumcentre(a, b, mesh_.points()[edges.apex(base)]);
    const Vector2 middle = (a + b) / 2;
    const double half = (b - a).norm() / 2;
    const Vector2 inward = Vector2(a.y() - b.y(), b.x() - a.x()).normalized();
    const double reach = (centre - middle).dot(inward);
    const double wanted = size_(middle + inward * half) / std::numbers::sqrt3;
    const double limit = reach > 0 ? (half * half + reach * reach) / (2 * reach) : half;
    const double radius = std::max(half, std::min(wanted, limit));
    return middle + inward * (radius + std::sqrt(radius * radius - half * half));
  }

  [[nodiscard]] bool isCrowded(const Vector2& place) const
  {
    const double clearance = kClearance * size_(place);
    return std::ranges::any_of(mesh_.points(), [&](const Vector2& p) { return (p - place).norm() < clearance; });
  }

  Delaunay& mesh_;
  const SizeFunction& size_;
  std::vector<Excess> excess_;
};

double smallestArea(const Delaunay& mesh, const std::vector<Index>& ring, const Vector2& place)
{
  double result = std::numeric_limits<double>::infinity();
  for (const Index h : ring) {
    const auto& p = mesh.points();
    result = std::min(result, orientation(place, p[mesh.edges().target(h)], p[mesh.edges().apex(h)]));
  }
  return result;
}

// Springs to all neighbours, stiffer where edges are to be shorter.
Vector2 relaxedPlace(const Delaunay& mesh, const std::vector<Index>& ring, Index vertex,
                     const std::vector<double>& sizes)
{
  Vector2 sum = Vector2::Zero();
  double weights = 0;
  for (const Index h : ring) {
    const Index neighbour = mesh.edges().target(h);
    const double weight = 1 / (sizes[vertex] + sizes[neighbour]);
    sum += weight * mesh.points()[neighbour];
    weights += weight;
  }
  return sum / weights;
}

void smooth(Delaunay& mesh, const std::vector<double>& sizes)
{
  constexpr double kStep = 0.7;
  for (Index vertex = 0; vertex < mesh.edges().vertexCount(); ++vertex) {
    if (mesh.isOnBoundary(vertex)) continue;
    const std::vector<Index> ring = mesh.edges().outgoing(vertex);
    const Vector2 here = mesh.points()[vertex];
    const Vector2 place = here + kStep * (relaxedPlace(mesh, ring, vertex, sizes) - here);
    if (smallestArea(mesh, ring, place) > 0) mesh.move(vertex, place);
  }
  mesh.restore();
}

// Drops the three corners of the surrounding triangle, which lie between boundary and inner points.
Region extract(const Delaunay& mesh, Index boundaryCount)
{
  Region result{mesh.points(), mesh.insideTriangles()};
  result.points.erase(result.points.begin() + boundaryCount, result.points.begin() + boundaryCount + 3);
  for (Triangle& triangle : result.triangles) {
    for (Index& corner : triangle) corner -= corner >= boundaryCount ? 3 : 0;
  }
  return result;
}

}  // namespace

SizeFunction sizeFromBoundary(const std::vector<Loop>& loops, double growth, double largest)
{
  struct Sample {
    Vector2 place;
    double length;
  };
  std::vector<Sample> samples;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector2& a = loop[i];
      const Vector2& b = loop[(i + 1) % loop.size()];
      samples.push_back({(a + b) / 2, (b - a).norm()});
    }
  }
  return [samples, growth, largest](const Vector2& place) {
    double result = largest;
    for (const Sample& sample : samples) {
      result = std::min(result, sample.length + growth * (place - sample.place).norm());
    }
    return result;
  };
}

Region meshRegion(const std::vector<Loop>& loops, const SizeFunction& size)
{
  Index boundaryCount = 0;
  for (const Loop& loop : loops) boundaryCount += static_cast<Index>(loop.size());
  Delaunay mesh(loops);
  Front(mesh, size).fill();
  // Vertices move little from here on: the wanted lengths where they are now will do.
  std::vector<double> sizes;
  for (const Vector2& point : mesh.points()) sizes.push_back(size(point));
  for (int step = 0; step < kSmoothingSteps; ++step) smooth(mesh, sizes);
  return extract(mesh, boundaryCount);
}

}  // namespace holdfast::generate
