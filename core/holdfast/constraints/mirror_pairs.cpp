#include "holdfast/constraints/mirror_pairs.h"

#include <numeric>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/surface/place_tree.h>

namespace holdfast {

MirrorPairs mirrorPairs(const Positions& places, std::span<const Index> wanted, const Vector3& point,
                        const Vector3& normal, double tolerance)
{
  const PlaceTree tree(places);
  const Vector3 n = normal.stableNormalized();
  const auto partnerOf = [&](Index k) {
    const Vector3 place = places.row(k);
    return tree.nearest(place - 2 * n.dot(place - point) * n, tolerance);
  };
  MirrorPairs result;
  for (const Index k : wanted) {
    const Index partner = partnerOf(k);
    if (partner < 0 || partnerOf(partner) != k)
      result.unpaired.push_back(k);
    else if (partner == k)
      result.onPlane.push_back(k);
    else
      result.pairs.push_back({std::min(k, partner), std::max(k, partner)});
  }
  result.pairs = sortedOnce(std::move(result.pairs));
  return result;
}

std::optional<MirrorConstraint> symmetryOf(const Positions& places, double tolerance)
{
  std::vector<Index> all(static_cast<std::size_t>(places.rows()));
  std::iota(all.begin(), all.end(), 0);
  const Vector3 middle = (places.colwise().minCoeff() + places.colwise().maxCoeff()).transpose() / 2;
  std::optional<MirrorConstraint> best;
  std::size_t fewest = all.size() / 2;
  for (const Vector3& point : {Vector3(Vector3::Zero()), middle})
    for (Index axis = 0; axis < 3; ++axis) {
      const Vector3 normal = Vector3::Unit(axis);
      const std::size_t unpaired = mirrorPairs(places, all, point, normal, tolerance).unpaired.size();
      if (unpaired >= fewest) continue;
      fewest = unpaired;
      best = MirrorConstraint{point, normal, {}, {AllOf{}}, {}};
    }
  return best;
}

}  // namespace holdfast
