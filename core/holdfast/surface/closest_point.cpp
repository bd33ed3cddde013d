#include "holdfast/surface/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
  for (int k = 0; k < 3; ++k) terms.push_back({tree_.triangles()[nearest][k], best.weights[k]});
  return {canonical(std::move(terms)), nearest, std::ldexp(std::sqrt(best.squaredDistance), exponent)};
}

}  // namespace holdfast
