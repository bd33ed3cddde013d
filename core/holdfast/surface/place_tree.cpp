#include "holdfast/surface/place_tree.h"

#include <tuple>

namespace holdfast {
namespace {

std::vector<Triangle> pointsAsTriangles(Index count)
{
  std::vector<Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < static_cast<int>(count); ++k) triangles.push_back({k, k, k});
  return triangles;
}

}  // namespace

PlaceTree::PlaceTree(const Positions& places)
    : places_(places), tree_(places, pointsAsTriangles(places.rows())), boxes_(tree_.boxesAt(places))
{
}

Index PlaceTree::nearest(const Vector3& from, double reach, Index except) const
{
  Index result = -1;
  double limit = reach;
  const auto entry = [&](const Eigen::AlignedBox3d& box, double most) {
    const double distance = box.exteriorDistance(from);
    return distance > most ? TriangleTree::kNever : distance;
  };
  tree_.visit(boxes_, entry, limit, [&](Index k) {
    const double distance = (places_.row(k).transpose() - from).norm();
    if (k == except || distance > limit) return false;
    if (result < 0 || distance < limit || k < result) std::tie(limit, result) = std::tuple(distance, k);
    return false;
  });
  return result;
}

}  // namespace holdfast
