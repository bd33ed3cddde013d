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

std::vector<Index> rowCounts(const ConstraintSystem& system, std::size_t constraintCount)
{
  std::vector<Index> counts(constraintCount, 0);
  for (const ConstraintRow& row : system.rows) ++counts[row.constraint];
  return counts;
}

/// Points and offsets have a target of their own that can be another one.
bool hasTarget(const Constraint& constraint)
{
  const RelativeConstraint* relative = std::get_if<RelativeConstraint>(&constraint.what);
  return std::holds_alternative<PointConstraint>(constraint.what) || (relative != nullptr && relative->offset);
}

/// Makes conflict sets of dependency groups.
class ConflictBuilder {
 public:
  ConflictBuilder(const ConstraintList& list, const ConstraintSystem& system,
                  const std::vector<DependencyGroups>& groups)
      : list_(list), system_(system), conflicts_(conflictCounts(groups)), rows_(rowCounts(system, groups.size()))
  {
  }

  [[nodiscard]] ConflictSet build(Index own, const ConstraintSet& others, const DependencyGroup& group) const
  {
    ConflictSet conflictSet{{}, group.rows, group.gap, group.isConflict, {}, {}};
    for (const Index other : others) conflictSet.with.push_back(list_.constraints[other].name);
    if (!group.isConflict) return conflictSet;
    conflictSet.disable = list_.constraints[cheapest(own, others)].name;
    if (hasTarget(list_.constraints[own]))
      conflictSet.consistentTarget = system_.rows[group.worstRow].target - group.gap;
    return conflictSet;
  }

 private:
  [[nodiscard]] Index cheapest(Index own, const ConstraintSet& others) const
  {
    const auto cost = [&](Index c) { return std::tuple(-conflicts_[c], rows_[c], -c); };
    Index best = own;
    for (const Index other : others)
      if (cost(other) < cost(best)) best = other;
    return best;
  }

  const ConstraintList& list_;
  const ConstraintSystem& system_;
  std::vector<Index> conflicts_;
  std::vector<Index> rows_;
};

}  // namespace

std::vector<std::vector<ConflictSet>> conflictSetsOf(const ConstraintList& list, const ConstraintSystem& system,
                                                     const Diagnosis& diagnosis)
{
  std::vector<DependencyGroups> groups = dependencyGroupsOf(system, diagnosis, list.constraints.size());
  for (DependencyGroups& own : groups) keepSmallest(own);
  const ConflictBuilder builder(list, system, groups);
  std::vector<std::vector<ConflictSet>> result(groups.size());
  for (std::size_t own = 0; own < groups.size(); ++own) {
    for (const auto& [others, group] : groups[own])
      result[own].push_back(builder.build(static_cast<Index>(own), others, group));
    std::stable_sort(result[own].begin(), result[own].end(), [](const ConflictSet& x, const ConflictSet& y) {
      return x.gap.stableNorm() > y.gap.stableNorm();
    });
  }
  return result;
}

}  // namespace holdfast
