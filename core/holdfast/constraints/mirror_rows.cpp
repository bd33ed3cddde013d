#include "holdfast/constraints/mirror_rows.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <holdfast/mesh/index_lists.h>

namespace holdfast {
namespace {

/// Those of the region that have partners; on the plane they are their own.
std::vector<Index> imageOf(const std::vector<Index>& region, const std::vector<Index>& partnerOf)
{
  std::vector<Index> image;
  for (const Index u : region)
    if (partnerOf[u] >= 0) image.push_back(partnerOf[u]);
  return sortedOnce(std::move(image));
}

/// Does nothing where all unknowns of the region turn together already.
void addRegion(ConstraintSystem& system, std::vector<Index> region)
{
  const auto hasAll = [&](const std::vector<Index>& other) { return std::ranges::includes(other, region); };
  if (region.size() > 1 && std::ranges::none_of(system.rigidRegions, hasAll))
    system.rigidRegions.push_back(std::move(region));
}

void handOnFlat(ConstraintSystem& system, const Vector3& normal, const std::vector<Index>& partnerOf)
{
  std::vector<char> isFlat(partnerOf.size(), 0);
  for (const FlatRotation& flat : system.flat) isFlat[flat.unknown] = 1;
  const std::size_t count = system.flat.size();
  for (std::size_t k = 0; k < count; ++k) {
    const FlatRotation flat = system.flat[k];
    const Index partner = partnerOf[flat.unknown];
    if (partner >= 0 && isFlat[partner] == 0)
      system.flat.push_back({partner, flat.normal - 2 * normal.dot(flat.normal) * normal});
  }
}

void handOn(ConstraintSystem& system, const MirrorPlane& mirror, std::vector<bool>& hasRotation)
{
  if (system.rotations.empty() && system.rigidRegions.empty()) return;
  std::vector<Index> partnerOf(hasRotation.size(), -1);
  for (const auto& [a, b] : mirror.partners.pairs) std::tie(partnerOf[a], partnerOf[b]) = std::pair(b, a);
  for (const Index u : mirror.partners.onPlane) partnerOf[u] = u;
  const std::size_t given = system.rotations.size();
  for (std::size_t k = 0; k < given; ++k) {
    GivenRotation image = system.rotations[k];
    image.unknown = partnerOf[image.unknown];
    if (image.unknown < 0 || hasRotation[image.unknown]) continue;
    // An axial vector.
    image.q = 2 * mirror.normal.dot(image.q) * mirror.normal - image.q;
    image.constraint = mirror.constraint;
    system.rotations.push_back(image);
    hasRotation[image.unknown] = true;
  }
  handOnFlat(system, mirror.normal, partnerOf);
  const std::size_t regions = system.rigidRegions.size();
  for (std::size_t k = 0; k < regions; ++k) addRegion(system, imageOf(system.rigidRegions[k], partnerOf));
}

}  // namespace

void addMirrorRows(ConstraintSystem& system, const MirrorConstraint& mirror, const MirrorPairs& partners,
                   Index constraint, const Positions& rest)
{
  const RowDirections along = RowDirections::along(mirror.normal);
  const Vector3& n = along.axis();
  const RowDirections across = RowDirections::across(n);
  const Vector3 twice = 2 * n.dot(mirror.point) * n;
  for (const auto& [a, b] : partners.pairs) {
    const Vector3 first = rest.row(a);
    const Vector3 second = rest.row(b);
    const Vector3 sum = twice - along.held(first + second);
    const Vector3 difference = across.held(second - first);
    system.rows.push_back({{{a, 1.0}, {b, 1.0}}, twice, sum, constraint, RowKind::Mirrored, 0, along});
    system.rows.push_back(
        {{{a, 1.0}, {b, -1.0}}, Vector3::Zero(), difference, constraint, RowKind::Mirrored, 0, across});
  }
  const OnPlane plane{mirror.point, mirror.normal, 0};
  for (const Index u : partners.onPlane) {
    const Vector3 place = rest.row(u);
    system.rows.push_back(
        {{{u, 1.0}}, plane.placeFrom(place), plane.shiftFrom(place), constraint, RowKind::Position, 0, along});
  }
}

void handOnRotations(ConstraintSystem& system, const std::vector<MirrorPlane>& mirrors, std::vector<bool>& hasRotation)
{
  for (bool isNews = true; isNews;) {
    const std::size_t before = system.rotations.size();
    const std::size_t regions = system.rigidRegions.size();
    for (const MirrorPlane& mirror : mirrors) handOn(system, mirror, hasRotation);
    isNews = system.rotations.size() > before || system.rigidRegions.size() > regions;
  }
}

}  // namespace holdfast
