#include "holdfast/geometry/enclosing_sphere.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <Eigen/QR>

namespace holdfast {
namespace {

// A point is on a sphere if it is farther from the middle than the radius by no more than this share: rounding.
constexpr double kOnSphere = 1e-13;

// Each round makes the sphere larger, and ten are usual; so many end a search that rounding leads in circles.
constexpr int kMostRounds = 1000;

// A sphere in space is that of four points at most.
constexpr std::size_t kMostSupports = 4;

struct Sphere {
  Vector3 center = Vector3::Zero();
  double radius = 0;

  [[nodiscard]] bool holds(const Vector3& point) const { return (point - center).norm() <= radius * (1 + kOnSphere); }
};

/// The smallest sphere through all of one to four points.
Sphere sphereThrough(const std::vector<Vector3>& points)
{
  Eigen::MatrixX3d arms(static_cast<Index>(points.size()) - 1, 3);
  for (Index k = 0; k < arms.rows(); ++k) arms.row(k) = points[k + 1] - points[0];
  if (arms.rows() == 0) return {points[0], 0};
  const Vector3 toCenter =
      arms.completeOrthogonalDecomposition().solve(Eigen::VectorXd(arms.rowwise().squaredNorm() / 2));
  return {points[0] + toCenter, toCenter.norm()};
}

/// The points that hold a sphere, and the sphere.
struct SupportedSphere {
  std::vector<Vector3> supports;
  Sphere sphere;
};

/// The smallest sphere around `supports` and `point`, which lies outside the one of `supports`, and so on the new one.
std::optional<SupportedSphere> sphereAround(const std::vector<Vector3>& supports, const Vector3& point)
{
  std::optional<SupportedSphere> best;
  for (unsigned chosen = 0; chosen < 1U << supports.size(); ++chosen) {
    std::vector<Vector3> points{point};
    for (std::size_t k = 0; k < supports.size(); ++k)
      if ((chosen >> k & 1U) != 0) points.push_back(supports[k]);
    if (points.size() > kMostSupports) continue;
    const Sphere sphere = sphereThrough(points);
    const auto isHeld = [&](const Vector3& support) { return sphere.holds(support); };
    if (std::ranges::all_of(supports, isHeld) && (!best || sphere.radius < best->sphere.radius))
      best = SupportedSphere{std::move(points), sphere};
  }
  return best;
}

/// The place of the row of `points` that is farthest from `center`.
Index farthestFrom(const Vector3& center, const Positions& points)
{
  Index place = 0;
  (points.rowwise() - center.transpose()).rowwise().squaredNorm().maxCoeff(&place);
  return place;
}

}  // namespace

double enclosingDiameter(const Positions& positions)
{
  if (positions.rows() == 0) return 0;
  Positions points = positions.rowwise() - positions.row(0);
  const double unit = points.cwiseAbs().maxCoeff();
  if (!(unit > 0)) return 0;
  points /= unit;
  SupportedSphere at{{points.row(0)}, {points.row(0), 0}};
  for (int round = 0; round < kMostRounds; ++round) {
    const Vector3 farthest = points.row(farthestFrom(at.sphere.center, points));
    if (at.sphere.holds(farthest)) break;
    const std::optional<SupportedSphere> larger = sphereAround(at.supports, farthest);
    if (!larger || larger->sphere.radius <= at.sphere.radius) break;
    at = *larger;
  }
  return 2 * at.sphere.radius * unit;
}

}  // namespace holdfast
