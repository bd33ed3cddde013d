#include "holdfast/surface/triangle_tree.h"

#include <algorithm>
#include <numeric>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr Index kLeafTriangles = 4;

}  // namespace

TriangleTree::TriangleTree(const Positions& positions, std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size())
{
  std::iota(order_.begin(), order_.end(), Index{0});
  Positions centers(static_cast<Index>(triangles_.size()), 3);
  for (Index t = 0; t < centers.rows(); ++t) {
    const auto& [a, b, c] = triangles_[t];
    centers.row(t) = positions.row(a) / 3 + positions.row(b) / 3 + positions.row(c) / 3;
  }
  if (!triangles_.empty()) addNode(0, centers.rows(), centers);
}

/// Adds the node of these triangles and all below it; returns its number.
Index TriangleTree::addNode(Index first, Index last, const Positions& centers)
{
  const Index node = static_cast<Index>(nodes_.size());
  nodes_.push_back({first, last, 0});
  if (last - first <= kLeafTriangles) return node;
  Eigen::AlignedBox3d box;
  for (Index k = first; k < last; ++k) box.extend(centers.row(order_[k]).transpose());
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const Index middle = first + (last - first) / 2;
  const auto isBefore = [&](Index s, Index t) {
    return std::pair(centers(s, axis), s) < std::pair(centers(t, axis), t);
  };
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, isBefore);
  addNode(first, middle, centers);
  const Index second = addNode(middle, last, centers);
  nodes_[node].second = second;
  return node;
}

TriangleTree::Boxes TriangleTree::boxesAt(const Positions& positions) const
{
  Boxes boxes(nodes_.size());
  const auto count = static_cast<Index>(boxes.size());
  parallelBlocks(count, [&](Index n) {
    const Node& node = nodes_[n];
    if (node.second == 0)
      for (Index k = node.first; k < node.last; ++k) boxes[n].extend(boxOf(order_[k], positions));
  });
  for (Index n = count - 1; n >= 0; --n)
    if (const Index second = nodes_[n].second; second != 0) boxes[n] = boxes[n + 1].merged(boxes[second]);
  return boxes;
}

void TriangleTree::split(const Boxes& boxes, NodePair pair, std::vector<NodePair>& pairs) const
{
  const auto push = [&](Index a, Index b) {
    if (a == b || boxes[a].intersects(boxes[b])) pairs.emplace_back(a, b);
  };
  auto [a, b] = pair;
  if (a == b) {
    push(a + 1, a + 1);
    push(nodes_[a].second, nodes_[a].second);
    push(a + 1, nodes_[a].second);
    return;
  }
  const auto size = [&](Index node) { return nodes_[node].last - nodes_[node].first; };
  const bool isFirstSplit = nodes_[a].second != 0 && (nodes_[b].second == 0 || size(a) >= size(b));
  if (!isFirstSplit) std::swap(a, b);
  push(a + 1, b);
  push(nodes_[a].second, b);
}

std::vector<TriangleTree::NodePair> TriangleTree::sharesOfPairs(const Boxes& boxes, std::size_t wanted) const
{
  std::vector<NodePair> shares;
  if (!nodes_.empty()) shares.emplace_back(0, 0);
  for (std::size_t before = 0; shares.size() < wanted && shares.size() != before;) {
    before = shares.size();
    std::vector<NodePair> next;
    for (const NodePair& pair : shares)
      if (areLeaves(pair))
        next.push_back(pair);
      else
        split(boxes, pair, next);
    shares = std::move(next);
  }
  return shares;
}

Eigen::AlignedBox3d TriangleTree::boxOf(Index triangle, const Positions& positions) const
{
  Eigen::AlignedBox3d box;
  for (const Index vertex : triangles_[triangle]) box.extend(positions.row(vertex).transpose());
  return box;
}

}  // namespace holdfast
