#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <holdfast/deform/outcomes.h>

namespace holdfast {
namespace {

using ConstraintSet = std::set<Index>;

/// Rows of one constraint that depend on the same other constraints.
struct DependencyGroup {
  Index rows = 0;
  Index worstRow = 0;
  Vector3 gap = Vector3::Zero();
  bool isConflict = false;
};

using DependencyGroups = std::map<ConstraintSet, DependencyGroup>;

/// The groups of every constraint, by the other constraints that they need.
std::vector<DependencyGroups> dependencyGroupsOf(const ConstraintSystem& system, const Diagnosis& diagnosis,
                                                 std::size_t constraintCount)
{
  std::vector<DependencyGroups> result(constraintCount);
  for (const auto& [dependency, gap] : diagnosis.dependent) {
    const Index own = system.rows[dependency.row].constraint;
    ConstraintSet others;
    for (const Term& term : dependency.terms) others.insert(system.rows[term.index].constraint);
    others.erase(own);
    DependencyGroup& group = result[own][others];
    if (group.rows++ == 0 || gap.stableNorm() > group.gap.stableNorm()) {
      group.gap = gap;
      group.worstRow = dependency.row;
    }
    group.isConflict = group.isConflict || diagnosis.status[dependency.row] == RowStatus::Conflicting;
  }
  return result;
}

/// Leaves out groups that need all constraints of another group of their kind and more.
void keepSmallest(DependencyGroups& groups)
{
  const auto needsMore = [&](const auto& group) {
    return std::any_of(groups.begin(), groups.end(), [&](const auto& other) {
      return other.second.isConflict == group.second.isConflict && other.first.size() < group.first.size() &&
             std::includes(group.first.begin(), group.first.end(), other.first.begin(), other.first.end());
    });
  };
  std::vector<ConstraintSet> larger;
  for (const auto& group : groups)
    if (needsMore(group)) larger.push_back(group.first);
  for (const ConstraintSet& set : larger) groups.erase(set);
}

/// How many conflicts each constraint takes part in.
std::vector<Index> conflictCounts(const std::vector<DependencyGroups>& groups)
{
  std::vector<Index> counts(groups.size(), 0);
  for (std::size_t own = 0; own < groups.size(); ++own)
    for (const auto& [others, group] : groups[own]) {
      if (!group.isConflict) continue;
      ++counts[own];
      for (const Index other : others) ++counts[other];
    }
  return counts;
}

/// Points and offsets have a target of their own that can be another one.
bool hasTarget(const Constraint& constraint)
{
  const RelativeConstraint* relative = std::get_if<RelativeConstraint>(&constraint.what);
  return std::holds_alternative<PointConstraint>(constraint.what) || (relative != nullptr && relative->offset);
}

/// The constraint whose end would end most conflicts, at the price of the fewest rows, the later one of equals.
Index cheapest(Index own, const ConstraintSet& others, const std::vector<Index>& conflicts,
               const std::vector<Index>& rows)
{
  const auto cost = [&](Index c) { return std::tuple(-conflicts[c], rows[c], -c); };
  Index best = own;
  for (const Index other : others)
    if (cost(other) < cost(best)) best = other;
  return best;
}

}  // namespace

std::vector<std::vector<ConflictSet>> conflictSetsOf(const ConstraintList& list, const ConstraintSystem& system,
                                                     const Diagnosis& diagnosis)
{
  std::vector<DependencyGroups> groups = dependencyGroupsOf(system, diagnosis, list.constraints.size());
  for (DependencyGroups& own : groups) keepSmallest(own);
  const std::vector<Index> conflicts = conflictCounts(groups);
  std::vector<Index> rows(groups.size(), 0);
  for (const ConstraintRow& row : system.rows) ++rows[row.constraint];
  std::vector<std::vector<ConflictSet>> result(groups.size());
  for (std::size_t own = 0; own < groups.size(); ++own) {
    for (const auto& [others, group] : groups[own]) {
      ConflictSet& set = result[own].emplace_back(ConflictSet{{}, group.rows, group.gap, group.isConflict, {}, {}});
      for (const Index other : others) set.with.push_back(list.constraints[other].name);
      if (!group.isConflict) continue;
      set.disable = list.constraints[cheapest(static_cast<Index>(own), others, conflicts, rows)].name;
      if (hasTarget(list.constraints[own])) set.consistentTarget = system.rows[group.worstRow].target - group.gap;
    }
    std::stable_sort(result[own].begin(), result[own].end(), [](const ConflictSet& x, const ConflictSet& y) {
      return x.gap.stableNorm() > y.gap.stableNorm();
    });
  }
  return result;
}

}  // namespace holdfast
