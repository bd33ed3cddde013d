#include "holdfast/widgets/marks/mark_set.h"

#include <algorithm>
#include <map>
#include <utility>

#include <holdfast/widgets/marks/evenly_spread.h>

namespace holdfast {
namespace {

/// Those of `group` that are drawn where there are too many.
std::vector<Index> thinned(const std::vector<ConstraintMark>& marks, const std::vector<Index>& group)
{
  Positions rest(static_cast<Index>(group.size()), 3);
  for (Index k = 0; k < rest.rows(); ++k) rest.row(k) = marks[group[k]].rest;
  std::vector<Index> kept;
  for (const Index k : evenlySpread(rest, kMostDots)) kept.push_back(group[k]);
  return kept;
}

/// Whether both lists hold the same places of the mesh and fared alike: then the same marks are drawn.
bool areDrawnAlike(const std::vector<ConstraintMark>& a, const std::vector<ConstraintMark>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ConstraintMark& p, const ConstraintMark& q) {
    return p.rest == q.rest && p.status == q.status && p.kind == q.kind;
  });
}

}  // namespace

bool isOff(ConstraintStatus status)
{
  return status == ConstraintStatus::Conflicting || status == ConstraintStatus::Missed;
}

std::vector<Index> drawnMarks(const std::vector<ConstraintMark>& marks)
{
  std::map<ConstraintStatus, std::vector<Index>> dots;
  std::vector<Index> drawn;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const bool isOneOfMany = !isSinglePoint(marks[k].kind) && !isOff(marks[k].status);
    (isOneOfMany ? dots[marks[k].status] : drawn).push_back(static_cast<Index>(k));
  }
  for (const auto& [status, group] : dots)
    for (const Index k : thinned(marks, group)) drawn.push_back(k);
  // What is disabled hides nothing.
  const auto gravity = [&](Index k) {
    return marks[k].status == ConstraintStatus::Disabled ? -1 : static_cast<int>(marks[k].status);
  };
  std::sort(drawn.begin(), drawn.end(),
            [&](Index a, Index b) { return std::pair(gravity(a), a) < std::pair(gravity(b), b); });
  return drawn;
}

std::shared_ptr<const MarkSet> markSet(std::vector<ConstraintMark> marks, const std::shared_ptr<const MarkSet>& before)
{
  std::vector<Index> drawn = before && areDrawnAlike(marks, before->marks) ? before->drawn : drawnMarks(marks);
  return std::make_shared<const MarkSet>(MarkSet{std::move(marks), std::move(drawn)});
}

}  // namespace holdfast
