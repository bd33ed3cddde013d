#include "holdfast/io/formats/stored_normals.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <holdfast/base/counted.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

/// For each normal, whether a face that uses it has a moved vertex.
std::vector<bool> affectedNormals(const Polygons& faces, std::span<const Index> normalOfCorner, Index count,
                                  const std::vector<bool>& moved)
{
  std::vector<bool> isAffected(count, false);
  std::size_t corner = 0;
  for (Index f = 0; f < faces.size(); ++f) {
    const auto polygon = faces[f];
    const bool hasMoved = std::any_of(polygon.begin(), polygon.end(), [&](Index v) { return moved[v]; });
    for (std::size_t k = 0; k < polygon.size(); ++k, ++corner)
      if (hasMoved && normalOfCorner[corner] >= 0) isAffected[normalOfCorner[corner]] = true;
  }
  return isAffected;
}

}  // namespace

std::vector<bool> movedVertices(const Positions& before, const Positions& after)
{
  assert(before.rows() == after.rows());
  std::vector<bool> moved(before.rows(), false);
  for (Index v = 0; v < before.rows(); ++v)
    for (Index k = 0; k < 3; ++k)
      if (!hasSameBits(before(v, k), after(v, k))) moved[v] = true;
  return moved;
}

NormalUpdate updateNormals(const Polygons& faces, std::span<const Index> normalOfCorner, Index count,
                           const Positions& before, const Positions& after)
{
  NormalUpdate update;
  update.normals = areaWeightedNormals(after, faces, normalOfCorner, count);
  update.isNew = affectedNormals(faces, normalOfCorner, count, movedVertices(before, after));
  Index recomputed = 0;
  Index kept = 0;
  for (Index n = 0; n < count; ++n) {
    if (!update.isNew[n]) continue;
    update.isNew[n] = !update.normals.row(n).isZero(0);
    ++(update.isNew[n] ? recomputed : kept);
  }
  if (recomputed > 0) update.notes.push_back(counted(recomputed, "normal") + " recomputed");
  if (kept > 0)
    update.notes.push_back(counted(kept, "normal") + " kept from before: the faces around have no area now");
  return update;
}

}  // namespace holdfast
