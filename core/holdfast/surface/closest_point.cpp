#include "holdfast/surface/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

namespace holdfast {
namespace {

TrianglePoint at(const std::array<Vector3, 3>& corners, const std::array<double, 3>& weights, const Vector3& place)
{
  const Vector3 position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  return {weights, position, (position - place).squaredNorm()};
}

/// The closest point of the side from corner k to the next.
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

struct ClosestPointSearch::Tree {
  std::vector<Triangle> triangles;
  int exponent = 0;  // a unit of what follows is 2^exponent model units
  std::vector<std::array<Vector3, 3>> corners;
  Eigen::KdBVH<double, 3, int> volumes;
};

namespace {

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

/// `vector` times 2^exponent; powers of two round nothing.
Vector3 scaled(const Vector3& vector, int exponent)
{
  return vector.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
}

/// What Eigen's minimiser asks for: lower bounds on boxes, values on triangles. Remembers the best triangle.
struct Nearest {
  using Scalar = double;

  double minimumOnVolume(const Eigen::AlignedBox3d& box) const
  {
    // A little less than it is: boxes no nearer than the best triangle are passed over, and one of them may hold an
    // equally near triangle that comes first in file order.
    return std::nextafter(box.squaredExteriorDistance(place), -1.0);
  }

  double minimumOnObject(int triangle)
  {
    const TrianglePoint candidate = closestPointOfTriangle(corners[static_cast<std::size_t>(triangle)], place);
    // Of triangles that share the closest point the first in file order is taken, whatever the order of the tree.
    if (candidate.squaredDistance < best.squaredDistance ||
        (candidate.squaredDistance == best.squaredDistance && triangle < bestTriangle)) {
      best = candidate;
      bestTriangle = triangle;
    }
    return candidate.squaredDistance;
  }

  const std::vector<std::array<Vector3, 3>>& corners;
  Vector3 place;
  TrianglePoint best{{}, Vector3::Zero(), std::numeric_limits<double>::infinity()};
  int bestTriangle = std::numeric_limits<int>::max();
};

}  // namespace

ClosestPointSearch::ClosestPointSearch(const Positions& positions, const std::vector<Triangle>& triangles)
{
  auto tree = std::make_unique<Tree>();
  tree->triangles = triangles;
  tree->exponent = exponentOf(largestCoordinate(positions, triangles));
  const auto corner = [&](Index v) { return scaled(positions.row(v), -tree->exponent); };
  tree->corners.reserve(triangles.size());
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) {
    tree->corners.push_back({corner(triangle[0]), corner(triangle[1]), corner(triangle[2])});
    Eigen::AlignedBox3d box;
    for (const Vector3& end : tree->corners.back()) box.extend(end);
    boxes.push_back(box);
  }
  std::vector<int> ids(triangles.size());
  std::iota(ids.begin(), ids.end(), 0);
  tree->volumes.init(ids.begin(), ids.end(), boxes.begin(), boxes.end());
  tree_ = std::move(tree);
}

ClosestPointSearch::~ClosestPointSearch() = default;
ClosestPointSearch::ClosestPointSearch(ClosestPointSearch&&) noexcept = default;
ClosestPointSearch& ClosestPointSearch::operator=(ClosestPointSearch&&) noexcept = default;

ClosestPointSearch::Result ClosestPointSearch::find(const Vector3& place) const
{
  const int exponent = std::max(tree_->exponent, exponentOf(place.cwiseAbs().maxCoeff()) - kFarthestExponent);
  Nearest nearest{tree_->corners, scaled(place, -exponent)};
  Eigen::BVMinimize(tree_->volumes, nearest);
  const Triangle& triangle = tree_->triangles[static_cast<std::size_t>(nearest.bestTriangle)];
  std::vector<Term> terms;
  for (int k = 0; k < 3; ++k) terms.push_back({triangle[k], nearest.best.weights[k]});
  return {canonical(std::move(terms)), nearest.bestTriangle,
          std::ldexp(std::sqrt(nearest.best.squaredDistance), exponent)};
}

}  // namespace holdfast
