#pragma once
/// A triangle tree puts boxes around triangles.

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// A triangle tree says which triangles lie together. It halves them by their centers along the longest side, again and
/// again. The boxes are apart from it, so that one tree serves the same triangles wherever they move.
class TriangleTree {
 public:
  struct Node {
    Index first = 0;   // of its triangles in `order`
    Index last = 0;    // past the last of them
    Index second = 0;  // node of its second half; that of the first half is the next one; 0 for a leaf
  };
  using Boxes = std::vector<Eigen::AlignedBox3d>;

  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// Positions must be finite. O(T log T).
  TriangleTree(const Positions& positions, std::vector<Triangle> triangles);

  [[nodiscard]] const std::vector<Triangle>& triangles() const noexcept { return triangles_; }

  /// Returns the box of each node with the triangles at `positions`. O(T).
  [[nodiscard]] Boxes boxesAt(const Positions& positions) const;
  [[nodiscard]] Eigen::AlignedBox3d boxOf(Index triangle, const Positions& positions) const;

  /// Calls `visit(triangle)` for the triangles of leaves that are met up to `limit`, until it returns true. A box is
  /// met at `entryOf(box, limit)`. Leaves come about from near to far. The limit may shrink on the way. A box at
  /// `kNever` is not met.
  template <class Entry, class Visitor>
  void visit(const Boxes& boxes, const Entry& entryOf, const double& limit, Visitor&& visit) const
  {
    if (nodes_.empty()) return;
    std::array<std::pair<double, Index>, kDeepest> waiting;
    std::size_t count = 0;
    const auto push = [&](double entry, Index node) {
      if (entry < kNever) waiting[count++] = {entry, node};
    };
    push(entryOf(boxes[0], limit), 0);
    while (count > 0) {
      const auto [entry, n] = waiting[--count];
      if (entry > limit) continue;
      const Node& node = nodes_[n];
      if (node.second == 0) {
        for (Index k = node.first; k < node.last; ++k)
          if (visit(order_[k])) return;
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

  /// A pair is two nodes whose triangles are to be compared. It may be one node twice, whose triangles are to be
  /// compared with one another.
  using NodePair = std::pair<Index, Index>;

  /// Returns pairs of nodes that cover all pairs of triangles whose boxes may meet, about as many as `wanted`. They are
  /// shares of the work for `visitPairs`, the same on every run. An empty tree has none.
  [[nodiscard]] std::vector<NodePair> sharesOfPairs(const Boxes& boxes, std::size_t wanted) const;

  /// Calls `visit(s, t)` once for each two triangles below `pair` that lie in leaves whose boxes meet. Looks at `most`
  /// pairs of nodes at most. Returns at how many it looked.
  template <class Visitor>
  std::size_t visitPairs(const Boxes& boxes, NodePair pair, std::size_t most, Visitor&& visit) const
  {
    std::vector<NodePair> waiting{pair};
    std::size_t count = 0;
    for (; !waiting.empty() && count < most; ++count) {
      const NodePair next = waiting.back();
      waiting.pop_back();
      if (!areLeaves(next)) {
        split(boxes, next, waiting);
        continue;
      }
      const Node& a = nodes_[next.first];
      const Node& b = nodes_[next.second];
      for (Index k = a.first; k < a.last; ++k)
        for (Index l = next.first == next.second ? k + 1 : b.first; l < b.last; ++l) visit(order_[k], order_[l]);
    }
    return count;
  }

 private:
  // Halves of halves of all triangles that an index can count.
  static constexpr std::size_t kDeepest = 64;

  Index addNode(Index first, Index last, const Positions& centers);
  [[nodiscard]] bool areLeaves(NodePair pair) const
  {
    return nodes_[pair.first].second == 0 && nodes_[pair.second].second == 0;
  }
  /// Adds to `pairs` those that `pair` falls apart into, if their boxes meet. `pair` must not be two leaves.
  void split(const Boxes& boxes, NodePair pair, std::vector<NodePair>& pairs) const;

  std::vector<Triangle> triangles_;
  std::vector<Index> order_;  // triangles as the leaves hold them
  std::vector<Node> nodes_;   // each before those below it
};

}  // namespace holdfast
