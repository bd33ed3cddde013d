#pragma once
/// Sets that only ever grow together (union-find).

#include <numeric>
#include <utility>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// The elements 0 .. size-1, each at first a set of its own. The smallest element of a set represents it. So numbering
/// by representatives does not depend on the order of `unite` calls. Each call costs nearly O(1).
class DisjointSets {
 public:
  explicit DisjointSets(Index size) : parent_(static_cast<std::size_t>(size))
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  [[nodiscard]] Index find(Index element)
  {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }

  void unite(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = static_cast<int>(a);
  }

  /// Makes the members of each group one set.
  void uniteEach(const std::vector<std::vector<Index>>& groups)
  {
    for (const std::vector<Index>& group : groups)
      for (const Index member : group) unite(group.front(), member);
  }

 private:
  std::vector<int> parent_;  // 32 bits: the time of `find` is that of the memory
};

}  // namespace holdfast
