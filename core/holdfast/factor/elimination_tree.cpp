#include "holdfast/factor/elimination_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace holdfast {
namespace {

/// The rows of the strict upper triangle by columns: of each column the earlier ones that it is tied to.
OrderedPattern transposed(const OrderedPattern& lower)
{
  OrderedPattern upper;
  const int n = lower.size();
  upper.start.assign(lower.start.size(), 0);
  for (const int row : lower.row) ++upper.start[row + 1];
  std::partial_sum(upper.start.begin(), upper.start.end(), upper.start.begin());
  upper.row.resize(lower.row.size());
  std::vector<int> next(upper.start.begin(), upper.start.end() - 1);
  for (int column = 0; column < n; ++column)
    for (int k = lower.start[column]; k < lower.start[column + 1]; ++k) upper.row[next[lower.row[k]]++] = column;
  return upper;
}

/// The root above `node`, whose `ancestor` is `kNoParent`; all on the way become children of it.
int rootOf(int node, std::vector<int>& ancestor)
{
  int root = node;
  while (ancestor[root] != kNoParent) root = ancestor[root];
  while (node != root) node = std::exchange(ancestor[node], root);
  return root;
}

}  // namespace

std::vector<int> inverse(const std::vector<int>& permutation)
{
  std::vector<int> result(permutation.size());
  for (std::size_t k = 0; k < permutation.size(); ++k) result[permutation[k]] = static_cast<int>(k);
  return result;
}

OrderedPattern orderedPattern(const SparseMatrix& lower, const std::vector<int>& order)
{
  const std::vector<int> place = inverse(order);
  const int n = static_cast<int>(order.size());
  OrderedPattern result;
  result.start.assign(order.size() + 1, 0);
  const auto forEach = [&](auto&& visit) {
    for (int column = 0; column < n; ++column)
      for (int k = lower.outerIndexPtr()[column]; k < lower.outerIndexPtr()[column + 1]; ++k)
        if (const int row = lower.innerIndexPtr()[k]; row != column) {
          const auto [first, second] = std::minmax(place[row], place[column]);
          visit(first, second, k);
        }
  };
  forEach([&](int column, int /*row*/, int /*source*/) { ++result.start[column + 1]; });
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.row.resize(static_cast<std::size_t>(result.start.back()));
  result.source.resize(result.row.size());
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  forEach([&](int column, int row, int source) {
    result.row[next[column]] = row;
    result.source[next[column]++] = source;
  });
  return result;
}

std::vector<int> eliminationTree(const OrderedPattern& pattern)
{
  const OrderedPattern upper = transposed(pattern);
  std::vector<int> parent(static_cast<std::size_t>(pattern.size()), kNoParent);
  std::vector<int> ancestor = parent;
  for (int column = 0; column < pattern.size(); ++column)
    for (int k = upper.start[column]; k < upper.start[column + 1]; ++k)
      for (int node = upper.row[k]; node != kNoParent && node != column;) {
        const int next = ancestor[node];
        ancestor[node] = column;
        if (next == kNoParent) parent[node] = column;
        node = next;
      }
  return parent;
}

std::vector<int> postorder(const std::vector<int>& parent)
{
  const int n = static_cast<int>(parent.size());
  std::vector<int> firstChild(parent.size(), kNoParent);
  std::vector<int> nextSibling(parent.size(), kNoParent);
  std::vector<int> open;  // roots, last first; then the way to the node that is visited
  for (int node = n - 1; node >= 0; --node) {
    if (parent[node] == kNoParent) {
      open.push_back(node);
      continue;
    }
    nextSibling[node] = firstChild[parent[node]];
    firstChild[parent[node]] = node;
  }
  std::vector<int> post;
  post.reserve(parent.size());
  while (!open.empty()) {
    const int node = open.back();
    if (const int child = firstChild[node]; child != kNoParent) {
      firstChild[node] = nextSibling[child];
      open.push_back(child);
    } else {
      post.push_back(node);
      open.pop_back();
    }
  }
  return post;
}

std::vector<int> columnCounts(const OrderedPattern& pattern, const std::vector<int>& parent,
                              const std::vector<int>& post)
{
  constexpr int kNoColumn = -1;
  const std::size_t n = parent.size();
  std::vector<int> firstDescendant(n, kNoColumn);  // places in `post`
  std::vector<int> count(n);
  for (std::size_t k = 0; k < n; ++k) {
    const int column = post[k];
    const bool isLeaf = firstDescendant[column] == kNoColumn;
    count[column] = isLeaf ? 1 : 0;
    for (int node = column; node != kNoParent && firstDescendant[node] == kNoColumn; node = parent[node])
      firstDescendant[node] = static_cast<int>(k);
  }
  // Every row of the factor is a subtree. A column is a leaf of it where its matrix entry reaches past all descendants
  // seen so far; two leaves in turn share the path from their common ancestor on, which is counted once.
  std::vector<int> ancestor(n, kNoParent);
  struct Leaf {
    int column = kNoColumn;
    int firstDescendant = kNoColumn;
  };
  std::vector<Leaf> lastLeaf(n);  // of each row
  for (const int column : post) {
    if (parent[column] != kNoParent) --count[parent[column]];
    for (int k = pattern.start[column]; k < pattern.start[column + 1]; ++k) {
      const int row = pattern.row[k];
      const int first = firstDescendant[column];
      if (first <= lastLeaf[row].firstDescendant) continue;
      ++count[column];
      if (lastLeaf[row].column != kNoColumn) --count[rootOf(lastLeaf[row].column, ancestor)];
      lastLeaf[row] = {column, first};
    }
    ancestor[column] = parent[column];
  }
  for (const int column : post)
    if (parent[column] != kNoParent) count[parent[column]] += count[column];
  return count;
}

}  // namespace holdfast
