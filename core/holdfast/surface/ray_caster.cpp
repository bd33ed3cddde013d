#include "holdfast/surface/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace holdfast {
namespace {

// Rounding of the three operations that give the distance of a side of a box, twice over.
constexpr double kBoxSlack = 1 + 8 * std::numeric_limits<double>::epsilon();

constexpr double kNever = TriangleTree::kNever;

}  // namespace

/// A ray made ready to meet many boxes and triangles. Triangles are met as by S. Woop, C. Benthin and I. Wald,
/// Watertight Ray/Triangle Intersection (JCGT 2, 2013): in coordinates in which the ray is the third axis, so that both
/// triangles at an edge compute the same sign for it.
class RayCaster::Caster {
 public:
  explicit Caster(const Ray& ray) : ray_(ray), inverse_(ray.direction.cwiseInverse())
  {
    ray.direction.cwiseAbs().maxCoeff(&z_);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_ = Vector3(ray.direction[x_], ray.direction[y_], 1) / ray.direction[z_];
  }

  /// The t at which the ray enters the box; infinite where it does not before `limit`.
  [[nodiscard]] double entry(const Eigen::AlignedBox3d& box, double limit) const
  {
    double enter = 0;
    double leave = limit;
    for (int k = 0; k < 3; ++k) {
      if (ray_.direction[k] == 0) {
        if (ray_.origin[k] < box.min()[k] || ray_.origin[k] > box.max()[k]) return kNever;
        continue;
      }
      const double a = (box.min()[k] - ray_.origin[k]) * inverse_[k];
      const double b = (box.max()[k] - ray_.origin[k]) * inverse_[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b) * kBoxSlack);
    }
    return enter <= leave ? enter : kNever;
  }

  /// The box with all around it that the reach could span where the box is.
  [[nodiscard]] Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box, const RayReach& reach) const
  {
    // A place p within reach of that at t has t |d| <= (p - origin) . d / |d| + radius + slope t.
    const double length = ray_.direction.norm();
    const Vector3 center = box.center() - ray_.origin;
    const double farthest =
        (center.dot(ray_.direction) + 0.5 * box.sizes().dot(ray_.direction.cwiseAbs())) / length + reach.radius;
    const double t = reach.slope < length ? farthest / (length - reach.slope) : kNever;
    const Vector3 margin = Vector3::Constant(reach.radius + reach.slope * std::max(t, 0.0));
    return {box.min() - margin, box.max() + margin};
  }

  [[nodiscard]] std::optional<RayHit> meet(Index triangle, const Triangle& corners, const Positions& positions) const
  {
    const Vector3 a = sheared(positions, corners[0]);
    const Vector3 b = sheared(positions, corners[1]);
    const Vector3 c = sheared(positions, corners[2]);
    const std::array<double, 3> w{side(b, c), side(c, a), side(a, b)};
    if ((w[0] < 0 || w[1] < 0 || w[2] < 0) && (w[0] > 0 || w[1] > 0 || w[2] > 0)) return std::nullopt;
    const double sum = w[0] + w[1] + w[2];
    if (sum == 0) return std::nullopt;
    // All have the sign of the sum or are zero: the quotients are not negative, and zeros shall not be either.
    RayHit hit{triangle, 0, {std::abs(w[0] / sum), std::abs(w[1] / sum), std::abs(w[2] / sum)}};
    hit.t = hit.weights[0] * a[2] + hit.weights[1] * b[2] + hit.weights[2] * c[2];
    if (!(hit.t > 0)) return std::nullopt;
    return hit;
  }

 private:
  [[nodiscard]] Vector3 sheared(const Positions& positions, Index vertex) const
  {
    const Vector3 place = positions.row(vertex).transpose() - ray_.origin;
    return {place[x_] - shear_[0] * place[z_], place[y_] - shear_[1] * place[z_], shear_[2] * place[z_]};
  }

  /// On which side of the ray a and b go by, as twice the area that they span with it.
  [[nodiscard]] static double side(const Vector3& a, const Vector3& b) { return a[0] * b[1] - a[1] * b[0]; }

  const Ray& ray_;
  Vector3 inverse_;
  Vector3 shear_;
  int x_ = 0;
  int y_ = 0;
  int z_ = 0;
};

RayCaster::RayCaster(const Positions& positions, std::vector<Triangle> triangles)
    : RayCaster(std::make_shared<const TriangleTree>(positions, std::move(triangles)),
                std::make_shared<const Positions>(positions))
{
}

RayCaster::RayCaster(std::shared_ptr<const TriangleTree> tree, std::shared_ptr<const Positions> positions)
    : tree_(std::move(tree)), positions_(std::move(positions))
{
}

std::optional<RayHit> RayCaster::firstHit(const Ray& ray, const RayRange& range) const
{
  const Caster caster(ray);
  RayHit best{-1, std::numeric_limits<double>::max(), {}};
  // Boxes hold what is hit only to rounding: an equally near triangle of smaller id must not be passed over.
  double limit = best.t;
  visit(std::bind_front(&Caster::entry, caster), limit, [&](Index triangle) {
    const std::optional<RayHit> hit = caster.meet(triangle, tree_->triangles()[triangle], *positions_);
    if (!hit || hit->t < range.begin || hit->t > range.end) return false;
    if (std::pair(hit->t, hit->triangle) >= std::pair(best.t, best.triangle)) return false;
    best = *hit;
    limit = best.t * kBoxSlack;
    return false;
  });
  return best.triangle < 0 ? std::nullopt : std::optional(best);
}

bool RayCaster::isBlocked(const Ray& ray, double before, std::span<const Index> ignored, double from) const
{
  const Caster caster(ray);
  bool isBlocked = false;
  visit(std::bind_front(&Caster::entry, caster), before, [&](Index triangle) {
    const std::optional<RayHit> hit = caster.meet(triangle, tree_->triangles()[triangle], *positions_);
    isBlocked =
        hit && hit->t >= from && hit->t < before && !std::binary_search(ignored.begin(), ignored.end(), triangle);
    return isBlocked;
  });
  return isBlocked;
}

std::vector<std::array<Vector3, 2>> RayCaster::cutBy(const Vector3& origin, const Vector3& normal) const
{
  const auto entryOf = [&](const Eigen::AlignedBox3d& box, double /*limit*/) {
    const double reach = kBoxSlack * box.sizes().dot(normal.cwiseAbs()) / 2;
    return std::abs((box.center() - origin).dot(normal)) <= reach ? 0 : kNever;
  };
  std::vector<std::array<Vector3, 2>> segments;
  constexpr double kNoLimit = 0;
  visit(entryOf, kNoLimit, [&](Index triangle) {
    std::array<Vector3, 3> corners;
    std::array<double, 3> heights{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = positions_->row(tree_->triangles()[triangle][k]).transpose();
      heights[k] = (corners[k] - origin).dot(normal);
    }
    std::array<Vector3, 2> segment;
    std::size_t ends = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if ((heights[k] >= 0) == (heights[next] >= 0)) continue;
      const double t = heights[k] / (heights[k] - heights[next]);
      segment[ends++] = corners[k] + t * (corners[next] - corners[k]);
    }
    if (ends == 2) segments.push_back(segment);
    return false;
  });
  return segments;
}

std::vector<Index> RayCaster::withinReach(const Ray& ray, const RayReach& reach) const
{
  const Caster caster(ray);
  const double limit = std::numeric_limits<double>::max();
  const auto entryOf = [&](const Eigen::AlignedBox3d& box, double before) {
    return caster.entry(caster.widened(box, reach), before);
  };
  std::vector<Index> found;
  visit(entryOf, limit, [&](Index triangle) {
    if (entryOf(tree_->boxOf(triangle, *positions_), limit) < kNever) found.push_back(triangle);
    return false;
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace holdfast
