#include "holdfast/ordering/elimination_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <holdfast/matrices/sparse_products.h>

namespace holdfast {
namespace {

/// Of each column the earlier ones that it is tied to.
struct UpperPattern {
  std::vector<int> start;
  std::vector<int> row;
};

/// Calls `visit(column, row)` for each entry below the diagonal.
template <class Visit>
void forEachBelow(const SparseMatrix& lower, const Visit& visit)
{
  for (int column = 0; column < lower.cols(); ++column)
    for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
      if (entry.row() != column) visit(column, static_cast<int>(entry.row()));
}

UpperPattern transposed(const SparseMatrix& lower)
{
  UpperPattern upper;
  upper.start.assign(static_cast<std::size_t>(lower.cols()) + 1, 0);
  forEachBelow(lower, [&](int /*column*/, int row) { ++upper.start[row + 1]; });
  std::partial_sum(upper.start.begin(), upper.start.end(), upper.start.begin());
  upper.row.resize(static_cast<std::size_t>(upper.start.back()));
  std::vector<int> next(upper.start.begin(), upper.start.end() - 1);
  forEachBelow(lower, [&](int column, int row) { upper.row[next[row]++] = column; });
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

SparseMatrix inOrder(const SparseMatrix& lower, const std::vector<int>& order)
{
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  const Index parts = threadCount();
  return sparseMatrix<SparseMatrix>(lower.rows(), lower.cols(), parts, [&](Index part, const auto& add) {
    for (Index k = part * lower.cols() / parts; k < (part + 1) * lower.cols() / parts; ++k)
      for (SparseMatrix::InnerIterator entry(lower, order[k]); entry; ++entry) {
        const Index other = place[entry.row()];
        add(std::max(k, other), std::min(k, other), entry.value());
      }
  });
}

std::vector<int> eliminationTree(const SparseMatrix& lower)
{
  const UpperPattern upper = transposed(lower);
  std::vector<int> parent(static_cast<std::size_t>(lower.cols()), kNoParent);
  std::vector<int> ancestor = parent;
  for (int column = 0; column < lower.cols(); ++column)
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

std::vector<int> columnCounts(const SparseMatrix& lower, const std::vector<int>& parent, const std::vector<int>& post)
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
    const int first = firstDescendant[column];
    for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
      const auto row = static_cast<int>(entry.row());
      if (row == column || first <= lastLeaf[row].firstDescendant) continue;
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
