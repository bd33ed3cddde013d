#include "holdfast/io/formats/stored_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/numbers/same_bits.h>
#include <holdfast/threads/parallel.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

/// For each face, whether it has a moved vertex.
std::vector<char> movedFaces(const Mesh& rest, const Positions& after)
{
  std::vector<char> hasMoved(static_cast<std::size_t>(rest.faces.size()));
  parallelBlocks(rest.faces.size(), [&](Index f) {
    hasMoved[f] = std::ranges::any_of(rest.faces[f], [&](Index v) { return !hasSameRow(rest.positions, after, v); });
  });
  return hasMoved;
}

/// A corner of a face, with the normal and the vertex that it names.
struct NormalCorner {
  int normal;
  int vertex;
  int corner;
  int face;

  // The compiler writes a zero where clang-tidy would have a null pointer.
  friend auto operator<=>(const NormalCorner&, const NormalCorner&) = default;  // NOLINT(modernize-use-nullptr)
};

/// All corners that name a normal which a moved face names, those of one normal and one vertex side by side.
std::vector<NormalCorner> touchedCorners(const Mesh& rest, const FileLayout& layout, const std::vector<char>& hasMoved)
{
  const auto forEach = [&](const auto& visit) {
    int corner = 0;
    for (Index f = 0; f < rest.faces.size(); ++f)
      for (const int v : rest.faces[f]) {
        const int normal = layout.normalOfCorner[corner];
        if (normal >= 0) visit(NormalCorner{normal, v, corner, static_cast<int>(f)});
        ++corner;
      }
  };
  std::vector<bool> isTouched(layout.normalCount, false);
  forEach([&](const NormalCorner& c) { isTouched[c.normal] = isTouched[c.normal] || hasMoved[c.face] != 0; });
  std::vector<NormalCorner> corners;
  forEach([&](const NormalCorner& c) {
    if (isTouched[c.normal]) corners.push_back(c);
  });
  std::ranges::sort(corners);
  return corners;
}

/// Calls `visit` for each run of `corners` in which `key` is the same.
template <class Key, class Visitor>
void forEachRun(std::span<const NormalCorner> corners, const Key& key, const Visitor& visit)
{
  for (std::size_t first = 0; first < corners.size();) {
    std::size_t last = first + 1;
    while (last < corners.size() && std::invoke(key, corners[last]) == std::invoke(key, corners[first])) ++last;
    visit(corners.subspan(first, last - first));
    first = last;
  }
}

// Finer than the digits that programs write, coarser than what rounding does to sums of areas.
constexpr double kSameNormal = 1e-9;

using RoundedNormal = std::array<Index, 3>;

RoundedNormal rounded(const Vector3& normal)
{
  RoundedNormal result{};
  for (Index k = 0; k < 3; ++k) result[k] = std::llround(normal[k] / kSameNormal);
  return result;
}

/// Gives the corners of moved faces normals of their own, one for all corners that agree on it.
class NormalSplitter {
 public:
  NormalSplitter(const Mesh& rest, const FileLayout& layout, const Positions& after)
      : rest_(rest),
        after_(after),
        hasMoved_(movedFaces(rest, after)),
        corners_(touchedCorners(rest, layout, hasMoved_))
  {
    update_.normals = Positions::Zero(layout.normalCount, 3);
    update_.isNew.assign(layout.normalCount, false);
  }

  NormalUpdate run()
  {
    forEachRun(corners_, &NormalCorner::normal, [&](std::span<const NormalCorner> all) { split(all); });
    note(recomputed_, " recomputed");
    note(std::ssize(update_.added), " added, because corners that moved shared one with others");
    note(kept_, " kept from before: the faces around have no area now");
    return std::move(update_);
  }

 private:
  static constexpr int kOwn = -1;  // the line of the normal that they share

  /// The corners at one vertex that share a normal, and what it is now.
  struct Group {
    std::span<const NormalCorner> corners;
    Vector3 normal;

    [[nodiscard]] bool hasVanished() const { return normal.isZero(0); }
  };

  void split(std::span<const NormalCorner> all)
  {
    groups_.clear();
    forEachRun(all, &NormalCorner::vertex, [&](std::span<const NormalCorner> atVertex) {
      if (std::ranges::any_of(atVertex, [&](const NormalCorner& c) { return hasMoved_[c.face] != 0; }))
        groups_.push_back({atVertex, sumOfAreas(atVertex, after_)});
    });
    const bool hasVanished = std::ranges::any_of(groups_, &Group::hasVanished);
    kept_ += hasVanished ? 1 : 0;
    mustStay_ = hasVanished || std::ranges::any_of(all, [&](const NormalCorner& c) { return hasMoved_[c.face] == 0; });
    entries_.clear();
    for (const Group& group : groups_)
      if (!group.hasVanished() && !(mustStay_ && isAsAtRest(group))) give(group.corners, group.normal);
  }

  [[nodiscard]] bool isAsAtRest(const Group& group) const
  {
    return rounded(sumOfAreas(group.corners, rest_.positions)) == rounded(group.normal);
  }

  /// To those of moved faces.
  void give(std::span<const NormalCorner> atVertex, const Vector3& normal)
  {
    const int entry = entryOf(atVertex.front().normal, normal);
    if (entry == kOwn) return;
    if (update_.addedOfCorner.empty()) update_.addedOfCorner.assign(rest_.faces.cornerCount(), -1);
    for (const NormalCorner& c : atVertex)
      if (hasMoved_[c.face] != 0) update_.addedOfCorner[c.corner] = entry;
  }

  /// The line for `normal` among those that corners of `shared` get.
  int entryOf(int shared, const Vector3& normal)
  {
    const bool takesOwn = entries_.empty() && !mustStay_;
    const int next = takesOwn ? kOwn : static_cast<int>(update_.added.size());
    const auto [entry, isNew] = entries_.emplace(rounded(normal), next);
    if (!isNew) return entry->second;
    if (takesOwn) {
      update_.normals.row(shared) = normal;
      update_.isNew[shared] = true;
      ++recomputed_;
    } else {
      update_.added.push_back({normal, shared});
    }
    return next;
  }

  [[nodiscard]] Vector3 sumOfAreas(std::span<const NormalCorner> atVertex, const Positions& positions) const
  {
    Vector3 sum = Vector3::Zero();
    for (const NormalCorner& c : atVertex) sum += areaVector(positions, rest_.faces[c.face]);
    return unitOrZero(sum);
  }

  void note(Index count, const char* what)
  {
    if (count > 0) update_.notes.push_back(counted(count, "normal") + what);
  }

  const Mesh& rest_;
  const Positions& after_;
  std::vector<char> hasMoved_;  // for each face
  std::vector<NormalCorner> corners_;
  std::vector<Group> groups_;             // those of the normal that is being split
  std::map<RoundedNormal, int> entries_;  // its lines
  bool mustStay_ = false;                 // corners keep it as it is
  Index recomputed_ = 0;
  Index kept_ = 0;
  NormalUpdate update_;
};

/// Where each normal belongs to one vertex or to one face.
NormalUpdate recomputed(const Mesh& rest, const FileLayout& layout, const Positions& after)
{
  NormalUpdate update{areaWeightedNormals(after, rest.faces, layout.normalOfCorner, layout.normalCount),
                      std::vector<bool>(layout.normalCount, false),
                      {},
                      {},
                      {}};
  const std::vector<char> hasMoved = movedFaces(rest, after);
  auto normal = layout.normalOfCorner.begin();
  for (Index f = 0; f < rest.faces.size(); ++f)
    for (std::size_t k = 0; k < rest.faces[f].size(); ++k, ++normal)
      if (hasMoved[f] != 0 && *normal >= 0) update.isNew[*normal] = true;
  Index count = 0;
  Index kept = 0;
  for (Index n = 0; n < layout.normalCount; ++n) {
    if (!update.isNew[n]) continue;
    update.isNew[n] = !update.normals.row(n).isZero(0);
    ++(update.isNew[n] ? count : kept);
  }
  if (count > 0) update.notes.push_back(counted(count, "normal") + " recomputed");
  if (kept > 0)
    update.notes.push_back(counted(kept, "normal") + " kept from before: the faces around have no area now");
  return update;
}

}  // namespace

NormalUpdate updateNormals(const Mesh& rest, const FileLayout& layout, const Positions& after)
{
  if (layout.normalCount == 0) return {};
  return layout.referencesIn == nullptr ? recomputed(rest, layout, after) : NormalSplitter(rest, layout, after).run();
}

bool hasSameRow(const Positions& a, const Positions& b, Index v)
{
  return hasSameBits(a(v, 0), b(v, 0)) && hasSameBits(a(v, 1), b(v, 1)) && hasSameBits(a(v, 2), b(v, 2));
}

}  // namespace holdfast
