#include "holdfast/ordering/supernodes.h"

#include <algorithm>
#include <utility>

#include <holdfast/ordering/elimination_tree.h>

namespace holdfast {
namespace {

/// Columns that have the same rows below them, one after the other on a path of the tree. Children come before parents.
std::vector<SupernodeDraft> fundamentalSupernodes(const std::vector<int>& parent, const std::vector<int>& post,
                                                  const std::vector<int>& count)
{
  std::vector<SupernodeDraft> drafts;
  std::vector<int> draftOf(parent.size());
  for (std::size_t k = 0; k < post.size(); ++k) {
    const int column = post[k];
    const bool continues = k > 0 && parent[post[k - 1]] == column && count[post[k - 1]] == count[column] + 1;
    if (!continues) drafts.emplace_back();
    drafts.back().columns.push_back(column);
    drafts.back().rowCount = count[column] - 1;
    draftOf[column] = static_cast<int>(drafts.size()) - 1;
  }
  for (std::size_t s = 0; s < drafts.size(); ++s)
    if (const int up = parent[drafts[s].columns.back()]; up != kNoParent)
      drafts[draftOf[up]].children.push_back(static_cast<int>(s));
  return drafts;
}

/// Narrow supernodes cost more to call than to compute: they may store many zeros, wide ones few.
bool mayStore(std::int64_t zeros, std::int64_t width, std::int64_t rowCount)
{
  if (width <= 4) return true;
  const std::int64_t entries = width * (width + 1) / 2 + width * rowCount;
  const double share = static_cast<double>(zeros) / static_cast<double>(entries);
  return share < (width <= 16 ? 0.5 : width <= 48 ? 0.1 : 0.05);
}

/// Merges children into their parents where that stores few zeros. Merged children have no columns left.
void mergeSupernodes(std::vector<SupernodeDraft>& drafts)
{
  for (SupernodeDraft& node : drafts) {
    std::vector<int> children = std::exchange(node.children, {});
    std::stable_sort(children.begin(), children.end(),
                     [&](int a, int b) { return drafts[a].rowCount > drafts[b].rowCount; });
    for (const int c : children) {
      SupernodeDraft& child = drafts[c];
      const auto width = static_cast<std::int64_t>(node.columns.size());
      const auto childWidth = static_cast<std::int64_t>(child.columns.size());
      const std::int64_t zeros = node.zeros + child.zeros + childWidth * (width + node.rowCount - child.rowCount);
      if (!mayStore(zeros, width + childWidth, node.rowCount)) {
        node.children.push_back(c);
        continue;
      }
      node.zeros = zeros;
      node.columns.insert(node.columns.begin(), child.columns.begin(), child.columns.end());
      node.children.insert(node.children.end(), child.children.begin(), child.children.end());
      child = {};
    }
  }
}

}  // namespace

std::vector<SupernodeDraft> supernodesOf(const std::vector<int>& parent, const std::vector<int>& post,
                                         const std::vector<int>& count)
{
  std::vector<SupernodeDraft> drafts = fundamentalSupernodes(parent, post, count);
  mergeSupernodes(drafts);
  return drafts;
}

}  // namespace holdfast
