#pragma once
/// Lists of indices say what meets at each vertex of a mesh.

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// The lists have any length, and lie side by side in memory.
class IndexLists {
 public:
  /// `forEach(add)` calls `add(list, index)` for each entry. It is called twice, to count and to add.
  template <class ForEach>
  IndexLists(Index count, const ForEach& forEach) : starts_(static_cast<std::size_t>(count) + 1, 0)
  {
    forEach([&](Index list, Index /*index*/) { ++starts_[list + 1]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    indices_.resize(static_cast<std::size_t>(starts_.back()));
    std::vector<Index> next(starts_.begin(), starts_.end() - 1);
    forEach([&](Index list, Index index) { indices_[next[list]++] = index; });
  }

  [[nodiscard]] Index size() const noexcept { return static_cast<Index>(starts_.size()) - 1; }

  /// Returns the indices of a list, in the order in which they were added.
  [[nodiscard]] std::span<const Index> operator[](Index list) const
  {
    return {indices_.begin() + starts_[list], indices_.begin() + starts_[list + 1]};
  }

 private:
  std::vector<Index> starts_;  // of each list in what follows, and the end
  std::vector<Index> indices_;
};

/// Returns the triangles at each vertex, ascending, each once. O(T + N).
[[nodiscard]] inline IndexLists trianglesOfVertices(const std::vector<Triangle>& triangles, Index vertexCount)
{
  return IndexLists(vertexCount, [&](const auto& add) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (auto corner = triangles[t].begin(); corner != triangles[t].end(); ++corner)
        if (std::find(triangles[t].begin(), corner, *corner) == corner) add(*corner, static_cast<Index>(t));
  });
}

/// Returns the values ascending, each once.
template <class Value>
[[nodiscard]] std::vector<Value> sortedOnce(std::vector<Value> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace holdfast
