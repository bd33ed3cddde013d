#include "holdfast/factor/symbolic_factor.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

#include <holdfast/ordering/supernodes.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// So many ranges keep so many threads busy. It is fixed: the order of sums must not depend on the machine.
constexpr int kRanges = 8;

/// Supernodes in the order of elimination, by ranges.
struct Layout {
  std::vector<int> drafts;
  std::vector<SupernodeRange> subtrees;
  SupernodeRange top;
};

/// The work of the subtree of each.
std::vector<double> subtreeWork(const std::vector<SupernodeDraft>& drafts)
{
  constexpr double kCall = 2000;  // flops that a supernode costs beside its own
  std::vector<double> work(drafts.size(), 0);
  for (std::size_t s = 0; s < drafts.size(); ++s) {
    const SupernodeDraft& draft = drafts[s];
    if (draft.columns.empty()) continue;
    work[s] = kCall + flopsOf(static_cast<double>(draft.columns.size()), static_cast<double>(draft.rowCount));
    for (const int child : draft.children) work[s] += work[child];
  }
  return work;
}

std::vector<int> rootsOf(const std::vector<SupernodeDraft>& drafts)
{
  std::vector<bool> isChild(drafts.size(), false);
  for (const SupernodeDraft& draft : drafts)
    for (const int child : draft.children) isChild[child] = true;
  std::vector<int> roots;
  for (std::size_t s = 0; s < drafts.size(); ++s)
    if (!isChild[s] && !drafts[s].columns.empty()) roots.push_back(static_cast<int>(s));
  return roots;
}

/// The subtree of `root`, children before parents.
void appendSubtree(const std::vector<SupernodeDraft>& drafts, int root, std::vector<int>& result)
{
  const auto begin = static_cast<std::ptrdiff_t>(result.size());
  std::vector<int> open{root};
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    result.push_back(node);
    open.insert(open.end(), drafts[node].children.begin(), drafts[node].children.end());
  }
  std::reverse(result.begin() + begin, result.end());
}

/// Takes the heaviest subtrees apart until none is heavier than the share of a range, and deals them out to ranges, the
/// heaviest first, each to the lightest range.
Layout layOut(const std::vector<SupernodeDraft>& drafts)
{
  const std::vector<double> work = subtreeWork(drafts);
  std::priority_queue<std::pair<double, int>> subtrees;
  double total = 0;
  for (const int root : rootsOf(drafts)) {
    subtrees.emplace(work[root], root);
    total += work[root];
  }
  std::vector<int> top;
  while (!subtrees.empty() && subtrees.top().first > total / kRanges) {
    const int node = subtrees.top().second;
    subtrees.pop();
    top.push_back(node);
    for (const int child : drafts[node].children) subtrees.emplace(work[child], child);
  }

  std::vector<std::vector<int>> ranges(kRanges);
  std::vector<double> load(kRanges, 0);
  for (; !subtrees.empty(); subtrees.pop()) {
    const auto lightest = std::min_element(load.begin(), load.end()) - load.begin();
    appendSubtree(drafts, subtrees.top().second, ranges[lightest]);
    load[lightest] += subtrees.top().first;
  }
  Layout layout;
  const auto append = [&](const std::vector<int>& nodes) {
    const int begin = static_cast<int>(layout.drafts.size());
    layout.drafts.insert(layout.drafts.end(), nodes.begin(), nodes.end());
    return SupernodeRange{begin, static_cast<int>(layout.drafts.size())};
  };
  for (const std::vector<int>& range : ranges)
    if (!range.empty()) layout.subtrees.push_back(append(range));
  std::sort(top.begin(), top.end());  // drafts number children before parents
  layout.top = append(top);
  return layout;
}

}  // namespace

double flopsOf(double width, double rowCount)
{
  return width * width * width / 3 + width * rowCount * (width + rowCount);
}

int SymbolicFactor::supernodeOf(int column) const
{
  const auto behind = std::ranges::upper_bound(supernodes, column, {}, &Supernode::firstColumn);
  return static_cast<int>(behind - supernodes.begin()) - 1;
}

std::vector<int> SymbolicFactor::withAncestors(const std::vector<int>& columns) const
{
  std::set<int> nodes;
  for (const int column : columns)
    for (int node = supernodeOf(column); node != kNoParent && nodes.insert(node).second;)
      node = supernodes[node].parent;
  return {nodes.begin(), nodes.end()};
}

int SymbolicFactor::topColumn() const
{
  return top.begin < top.end ? supernodes[top.begin].firstColumn : size();
}

std::int64_t SymbolicFactor::nonzeros() const
{
  std::int64_t sum = 0;
  for (const Supernode& node : supernodes)
    sum += std::int64_t{node.width} * (node.width + 1) / 2 + std::int64_t{node.width} * node.rowCount;
  return sum;
}

double SymbolicFactor::flops() const
{
  return std::transform_reduce(supernodes.begin(), supernodes.end(), 0.0, std::plus(),
                               [](const Supernode& node) { return flopsOf(node.width, node.rowCount); });
}

bool SymbolicFactor::hasMultipliers() const
{
  return std::ranges::any_of(supernodes, [](const Supernode& node) { return node.multipliers > 0; });
}

// The rows below each supernode: those of its columns in M, and those of its children. The first tells its parent.
void complete(SymbolicFactor& factor, const SparseMatrix& lower)
{
  factor.children.resize(factor.supernodes.size());
  // `all` holds the rows of the children, too.
  const auto addRange = [&](const SupernodeRange& range, std::vector<int>& all, std::vector<int>& seenBy) {
    seenBy.resize(factor.order.size(), kNoParent);
    for (int s = range.begin; s < range.end; ++s) {
      Supernode& node = factor.supernodes[s];
      node.firstRow = static_cast<std::int64_t>(all.size());
      for (int column = node.firstColumn; column < node.end(); ++column) all.push_back(column);
      const auto add = [&](int row) {
        if (row >= node.end() && std::exchange(seenBy[row], s) != s) all.push_back(row);
      };
      const int* const rows = lower.innerIndexPtr();
      std::for_each(rows + lower.outerIndexPtr()[node.firstColumn], rows + lower.outerIndexPtr()[node.end()], add);
      for (const int child : factor.children[s]) {
        const Supernode& below = factor.supernodes[child];
        for (std::int64_t k = below.firstRow + below.width; k < below.firstRow + below.height(); ++k) add(all[k]);
      }
      const auto behind = all.begin() + node.firstRow + node.width;
      std::sort(behind, all.end());
      node.rowCount = static_cast<int>(all.end() - behind);
      if (node.rowCount == 0) continue;
      node.parent = factor.supernodeOf(*behind);
      if (node.parent < range.end) factor.children[node.parent].push_back(s);
    }
  };
  std::vector<std::vector<int>> rows(factor.subtrees.size());
  std::vector<std::vector<int>> seenBy(static_cast<std::size_t>(threadCount()));
  parallelFor(static_cast<Index>(rows.size()),
              [&](Index k, Index thread) { addRange(factor.subtrees[k], rows[k], seenBy[thread]); });
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (int s = factor.subtrees[k].begin; s < factor.subtrees[k].end; ++s) {
      Supernode& node = factor.supernodes[s];
      node.firstRow += static_cast<std::int64_t>(factor.rows.size());
      if (node.parent >= factor.top.begin) factor.children[node.parent].push_back(s);
    }
    factor.rows.insert(factor.rows.end(), rows[k].begin(), rows[k].end());
  }
  addRange(factor.top, factor.rows, seenBy.front());
}

SymbolicFactor analyze(SparseMatrix& lower, const std::vector<int>& order)
{
  if (!std::ranges::is_sorted(order)) lower = inOrder(lower, order);
  const std::vector<int> parent = eliminationTree(lower);
  const std::vector<int> post = postorder(parent);
  const std::vector<SupernodeDraft> drafts = supernodesOf(parent, post, columnCounts(lower, parent, post));
  const Layout layout = layOut(drafts);

  SymbolicFactor factor;
  for (const int draft : layout.drafts) {
    const std::vector<int>& columns = drafts[draft].columns;
    factor.supernodes.push_back({factor.size(), static_cast<int>(columns.size())});
    factor.order.insert(factor.order.end(), columns.begin(), columns.end());
  }
  factor.subtrees = layout.subtrees;
  factor.top = layout.top;
  lower = inOrder(lower, factor.order);
  complete(factor, lower);
  for (int& column : factor.order) column = order[column];
  return factor;
}

}  // namespace holdfast
