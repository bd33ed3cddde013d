#include "holdfast/surface/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace holdfast {
namespace {

constexpr Index kLeafTriangles = 4;

// Halves of halves of all triangles that an index can count.
constexpr std::size_t kDeepest = 64;

// Rounding of the three operations that give the distance of a side of a box, twice over.
constexpr double kBoxSlack = 1 + 8 * std::numeric_limits<double>::epsilon();

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

/// Which triangles the boxes hold, whatever their places.
struct RayCaster::Tree {
  struct Node {
    Index first = 0;   // of its triangles in `order`
    Index last = 0;    // past the last of them
    Index second = 0;  // node of its second half; that of the first half is the next one; 0 for a leaf
  };

  Tree(const Positions& positions, std::vector<Triangle> itsTriangles);
  Index addNode(Index first, Index last, const Positions& centers);

  std::vector<Triangle> triangles;
  std::vector<Index> order;  // triangles as the leaves hold them
  std::vector<Node> nodes;   // each before those below it
};

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

  [[nodiscard]] auto entries() const
  {
    return [this](const Eigen::AlignedBox3d& box, double limit) { return entry(box, limit); };
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

RayCaster::Tree::Tree(const Positions& positions, std::vector<Triangle> itsTriangles)
    : triangles(std::move(itsTriangles)), order(triangles.size())
{
  std::iota(order.begin(), order.end(), Index{0});
  Positions centers(static_cast<Index>(triangles.size()), 3);
  for (Index t = 0; t < centers.rows(); ++t) {
    const auto& [a, b, c] = triangles[t];
    centers.row(t) = positions.row(a) / 3 + positions.row(b) / 3 + positions.row(c) / 3;
  }
  if (!triangles.empty()) addNode(0, centers.rows(), centers);
}

/// Adds the node of these triangles and all below it; returns its number.
Index RayCaster::Tree::addNode(Index first, Index last, const Positions& centers)
{
  const Index node = static_cast<Index>(nodes.size());
  nodes.push_back({first, last, 0});
  if (last - first <= kLeafTriangles) return node;
  Eigen::AlignedBox3d box;
  for (Index k = first; k < last; ++k) box.extend(centers.row(order[k]).transpose());
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const Index middle = first + (last - first) / 2;
  const auto isBefore = [&](Index s, Index t) {
    return std::pair(centers(s, axis), s) < std::pair(centers(t, axis), t);
  };
  std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last, isBefore);
  addNode(first, middle, centers);
  const Index second = addNode(middle, last, centers);
  nodes[node].second = second;
  return node;
}

RayCaster::RayCaster(const Positions& positions, std::vector<Triangle> triangles)
    : RayCaster(std::make_shared<const Tree>(positions, std::move(triangles)),
                std::make_shared<const Positions>(positions))
{
}

RayCaster::RayCaster(std::shared_ptr<const Tree> tree, std::shared_ptr<const Positions> positions)
    : tree_(std::move(tree)), positions_(std::move(positions))
{
  auto boxes = std::make_shared<std::vector<Eigen::AlignedBox3d>>(tree_->nodes.size());
  for (Index n = static_cast<Index>(boxes->size()) - 1; n >= 0; --n) {
    const Tree::Node& node = tree_->nodes[n];
    Eigen::AlignedBox3d& box = (*boxes)[n];
    if (node.second != 0) {
      box = (*boxes)[n + 1].merged((*boxes)[node.second]);
    } else {
      for (Index k = node.first; k < node.last; ++k) box.extend(boxOf(tree_->order[k]));
    }
  }
  boxes_ = std::move(boxes);
}

RayCaster RayCaster::movedTo(std::shared_ptr<const Positions> positions) const
{
  return {tree_, std::move(positions)};
}

Eigen::AlignedBox3d RayCaster::boxOf(Index triangle) const
{
  Eigen::AlignedBox3d box;
  for (const Index vertex : tree_->triangles[triangle]) box.extend(positions_->row(vertex).transpose());
  return box;
}

/// Calls `visit(leaf)` for the leaves whose boxes the ray enters up to `limit`, at `entryOf(box, limit)`, about from
/// near to far, until it returns true. The limit may shrink on the way.
template <class Entry, class Visitor>
void RayCaster::visitLeaves(const Entry& entryOf, const double& limit, Visitor&& visit) const
{
  const std::vector<Tree::Node>& nodes = tree_->nodes;
  const std::vector<Eigen::AlignedBox3d>& boxes = *boxes_;
  if (nodes.empty()) return;
  std::array<std::pair<double, Index>, kDeepest> waiting;
  std::size_t count = 0;
  const auto push = [&](double entry, Index node) {
    if (entry < kNever) waiting[count++] = {entry, node};
  };
  push(entryOf(boxes[0], limit), 0);
  while (count > 0) {
    const auto [entry, n] = waiting[--count];
    if (entry > limit) continue;
    const Tree::Node& node = nodes[n];
    if (node.second == 0) {
      if (visit(node)) return;
      continue;
    }
    const double first = entryOf(boxes[n + 1], limit);
    const double second = entryOf(boxes[node.second], limit);
    // What lies nearer is looked at first: it may spare the other.
    if (first <= second) {
      push(second, node.second);
      push(first, n + 1);
    } else {
      push(first, n + 1);
      push(second, node.second);
    }
  }
}

std::optional<RayHit> RayCaster::firstHit(const Ray& ray, const RayRange& range) const
{
  const Caster caster(ray);
  const std::vector<Index>& order = tree_->order;
  RayHit best{-1, std::numeric_limits<double>::max(), {}};
  // Boxes hold what is hit only to rounding: an equally near triangle of smaller id must not be passed over.
  double limit = best.t;
  visitLeaves(caster.entries(), limit, [&](const Tree::Node& leaf) {
    for (Index k = leaf.first; k < leaf.last; ++k) {
      const std::optional<RayHit> hit = caster.meet(order[k], tree_->triangles[order[k]], *positions_);
      if (!hit || hit->t < range.begin || hit->t > range.end) continue;
      if (std::pair(hit->t, hit->triangle) >= std::pair(best.t, best.triangle)) continue;
      best = *hit;
      limit = best.t * kBoxSlack;
    }
    return false;
  });
  return best.triangle < 0 ? std::nullopt : std::optional(best);
}

bool RayCaster::isBlocked(const Ray& ray, double before, std::span<const Index> ignored, double from) const
{
  const Caster caster(ray);
  const std::vector<Index>& order = tree_->order;
  bool isBlocked = false;
  visitLeaves(caster.entries(), before, [&](const Tree::Node& leaf) {
    for (Index k = leaf.first; k < leaf.last && !isBlocked; ++k) {
      const std::optional<RayHit> hit = caster.meet(order[k], tree_->triangles[order[k]], *positions_);
      isBlocked =
          hit && hit->t >= from && hit->t < before && !std::binary_search(ignored.begin(), ignored.end(), order[k]);
    }
    return isBlocked;
  });
  return isBlocked;
}

std::vector<Index> RayCaster::withinReach(const Ray& ray, const RayReach& reach) const
{
  const Caster caster(ray);
  const std::vector<Index>& order = tree_->order;
  const double limit = std::numeric_limits<double>::max();
  const auto entryOf = [&](const Eigen::AlignedBox3d& box, double before) {
    return caster.entry(caster.widened(box, reach), before);
  };
  std::vector<Index> found;
  visitLeaves(entryOf, limit, [&](const Tree::Node& leaf) {
    for (Index k = leaf.first; k < leaf.last; ++k)
      if (entryOf(boxOf(order[k]), limit) < kNever) found.push_back(order[k]);
    return false;
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace holdfast
