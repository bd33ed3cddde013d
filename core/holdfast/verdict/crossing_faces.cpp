#include "holdfast/verdict/crossing_faces.h"

#include <algorithm>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// A share of the diagonal, a tenth of what is seen. Slivers of neighbouring faces pass one another by less, without a
// sign of it in a picture.
constexpr double kTouch = kVisible / 10;

// A share of a triangle's area: what passes through its border does not pass through its inside.
constexpr double kBorder = 1e-9;

// Shares of the work after each of which it can be stopped.
constexpr std::size_t kShares = 1024;
constexpr std::size_t kSharesAtOnce = 32;

// Pairs of boxes that are looked at for each triangle, in all and in one share. Surfaces that do not cross themselves
// have about three.
constexpr std::size_t kMostPairs = 16;
constexpr double kMostPairsOfShare = 0.5;
constexpr std::size_t kFewPairs = 100'000;

using TriangleCorners = std::array<Vector3, 3>;

/// About the center: products of four lengths stay in the range of doubles.
Positions inDiagonals(const RestSurface& rest, const Positions& positions)
{
  return rest.perUnit * (positions.rowwise() - rest.center.transpose());
}

TriangleCorners cornersAt(const Triangle& triangle, const Positions& positions)
{
  return {positions.row(triangle[0]), positions.row(triangle[1]), positions.row(triangle[2])};
}

bool isInsideTriangle(const TriangleCorners& corners, const Vector3& normal, const Vector3& place)
{
  const double border = kBorder * normal.squaredNorm();
  for (int k = 0; k < 3; ++k)
    if (normal.dot((corners[(k + 1) % 3] - corners[k]).cross(place - corners[k])) <= border) return false;
  return true;
}

/// Heights of three places over the plane of a triangle, times the length of its normal; 0 for those that touch it.
std::array<double, 3> heightsOver(const TriangleCorners& corners, const Vector3& normal, const TriangleCorners& places,
                                  double touch)
{
  std::array<double, 3> heights{};
  const double least = touch * normal.norm();
  for (int k = 0; k < 3; ++k) {
    const double height = normal.dot(places[k] - corners[0]);
    heights[k] = std::abs(height) <= least ? 0 : height;
  }
  return heights;
}

/// Tells whether an edge of `other` runs through the triangle; `shared` is the corner of `other` that both have, or -1.
bool isPierced(const TriangleCorners& corners, const TriangleCorners& other, int shared, double touch)
{
  const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const std::array<double, 3> heights = heightsOver(corners, normal, other, touch);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (k == shared || next == shared || heights[k] * heights[next] >= 0) continue;
    const double share = heights[k] / (heights[k] - heights[next]);
    if (isInsideTriangle(corners, normal, other[k] + share * (other[next] - other[k]))) return true;
  }
  return false;
}

int cornerIn(const Triangle& triangle, const Triangle& other)
{
  for (int k = 0; k < 3; ++k)
    if (std::ranges::find(other, triangle[k]) != other.end()) return k;
  return -1;
}

bool shareAnEdge(const Triangle& a, const Triangle& b)
{
  return std::ranges::count_if(a, [&](int vertex) { return std::ranges::find(b, vertex) != b.end(); }) > 1;
}

}  // namespace

bool areCrossing(const Triangle& a, const Triangle& b, const Positions& positions, double touch)
{
  if (shareAnEdge(a, b)) return false;
  const TriangleCorners atA = cornersAt(a, positions);
  const TriangleCorners atB = cornersAt(b, positions);
  return isPierced(atA, atB, cornerIn(b, a), touch) || isPierced(atB, atA, cornerIn(a, b), touch);
}

CrossingSearch::CrossingSearch(const RestSurface& rest, const Positions& atRest)
    : rest_(rest), atRest_(atRest), tree_(inDiagonals(rest, atRest), rest.triangles)
{
}

CrossingTriangles CrossingSearch::find(const Positions& now, Progress& progress)
{
  const Pairs pairs = pairsAt(now, progress);
  if (!pairs.crossing.empty() && !isCrossedAtRest_) markCrossedAtRest(progress);
  const auto isCrossed = [&](int triangle) {
    return std::ranges::any_of(rest_.triangles[triangle], [&](int vertex) { return (*isCrossedAtRest_)[vertex]; });
  };
  std::vector<int> crossing;
  for (const auto& [a, b] : pairs.crossing)
    if (!isCrossed(a) && !isCrossed(b)) crossing.insert(crossing.end(), {a, b});
  return {sortedOnce(std::move(crossing)), pairs.areAll};
}

CrossingSearch::Pairs CrossingSearch::pairsAt(const Positions& places, Progress& progress) const
{
  const Positions positions = inDiagonals(rest_, places);
  const TriangleTree::Boxes boxes = tree_.boxesAt(positions);
  const std::vector<TriangleTree::NodePair> shares = tree_.sharesOfPairs(boxes, kShares);
  const std::size_t mostOfShare =
      std::max(kFewPairs, static_cast<std::size_t>(kMostPairsOfShare * static_cast<double>(rest_.triangles.size())));
  const std::size_t most = std::max(kFewPairs, kMostPairs * rest_.triangles.size());
  std::vector<Pairs> found(shares.size());
  std::vector<std::size_t> counts(shares.size(), 0);
  const auto compare = [&](Index share) {
    counts[share] = tree_.visitPairs(boxes, shares[share], mostOfShare, [&](Index a, Index b) {
      if (!tree_.boxOf(a, positions).intersects(tree_.boxOf(b, positions))) return;
      if (areCrossing(rest_.triangles[a], rest_.triangles[b], positions, kTouch))
        found[share].crossing.emplace_back(a, b);
    });
    found[share].areAll = counts[share] < mostOfShare;
  };
  Pairs pairs;
  std::size_t count = 0;
  for (std::size_t first = 0; first < shares.size(); first += kSharesAtOnce) {
    progress.proceed(static_cast<double>(first) / static_cast<double>(shares.size()));
    const std::size_t end = std::min(first + kSharesAtOnce, shares.size());
    parallelFor(static_cast<Index>(end - first), [&](Index k) { compare(static_cast<Index>(first) + k); });
    for (std::size_t share = first; share < end; ++share) {
      const auto& [crossing, areAll] = found[share];
      pairs.crossing.insert(pairs.crossing.end(), crossing.begin(), crossing.end());
      pairs.areAll = pairs.areAll && areAll;
      count += counts[share];
    }
    if (count > most && end < shares.size()) {
      pairs.areAll = false;
      break;
    }
  }
  return pairs;
}

void CrossingSearch::markCrossedAtRest(Progress& progress)
{
  std::vector<bool> isCrossed(static_cast<std::size_t>(atRest_.rows()), false);
  for (const auto& [a, b] : pairsAt(atRest_, progress).crossing)
    for (const int triangle : {a, b})
      for (const int vertex : rest_.triangles[triangle]) isCrossed[vertex] = true;
  isCrossedAtRest_ = std::move(isCrossed);
}

}  // namespace holdfast
