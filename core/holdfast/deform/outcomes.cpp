#include "holdfast/deform/outcomes.h"

#include <map>
#include <set>
#include <tuple>

#include <holdfast/base/parallel.h>
#include <holdfast/deform/deform_details.h>

namespace holdfast {
namespace {

using ConstraintSet = std::set<Index>;

/// Rows of one constraint that depend on the same other constraints.
struct DependencyGroup {
  Index rows = 0;
  Index worstRow = 0;
  Vector3 gap = Vector3::Zero();
  bool isConflict = false;
  bool needsOwn = false;  // depends on others of its own rows as well
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
    const bool needsOwn = others.erase(own) > 0;
    DependencyGroup& group = result[own][others];
    group.needsOwn = group.needsOwn || needsOwn;
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

/// For each constraint of the list, the sets with which it conflicts or which it repeats, the largest gap first. A set
/// that holds all constraints of another one and more is left out. O(dependent rows times terms).
std::vector<std::vector<ConflictSet>> conflictSetsOf(const ConstraintList& list, const ConstraintSystem& system,
                                                     std::vector<DependencyGroups> groups,
                                                     const std::vector<Index>& rows)
{
  for (DependencyGroups& own : groups) keepSmallest(own);
  const std::vector<Index> conflicts = conflictCounts(groups);
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

/// An enabled constraint without rows, as a rigid region of one vertex, asks for nothing and holds.
ConstraintStatus statusOf(const DependencyGroups& groups, Index rows, bool isEnabled)
{
  if (!isEnabled) return ConstraintStatus::Disabled;
  for (const auto& [others, group] : groups) {
    if (group.isConflict) return ConstraintStatus::Conflicting;
    rows -= group.rows;
  }
  return rows == 0 ? ConstraintStatus::Redundant : ConstraintStatus::Independent;
}

/// The limit of a constraint is the largest of its rows.
void setLimits(std::vector<ConstraintOutcome>& outcomes, const ConstraintSystem& system,
               const std::vector<double>& limits)
{
  for (ConstraintOutcome& outcome : outcomes) outcome.limit.reset();
  for (std::size_t r = 0; r < limits.size(); ++r) {
    std::optional<double>& limit = outcomes[system.rows[r].constraint].limit;
    limit = std::max(limit.value_or(0), limits[r]);
  }
}

}  // namespace

std::string_view name(ConstraintStatus status)
{
  constexpr std::array kNames{"independent", "met", "redundant", "conflicting", "missed", "disabled"};
  return kNames[static_cast<std::size_t>(status)];
}

std::string_view name(SolveStatus status)
{
  constexpr std::array kNames{"not run", "ok", "conflicts", "failed"};
  return kNames[static_cast<std::size_t>(status)];
}

std::vector<double> rowResiduals(const ConstraintSystem& system, const Weld& weld, const Positions& positions)
{
  std::vector<double> residuals(system.rows.size());
  parallelBlocks(static_cast<Index>(residuals.size()), [&](Index r) {
    const ConstraintRow& row = system.rows[r];
    Vector3 at = Vector3::Zero();
    for (const Term& term : row.terms)
      at += term.coefficient * positions.row(weld.firstVertexOf[term.index]).transpose();
    residuals[r] = (at - row.target).stableNorm();
  });
  return residuals;
}

std::vector<ConstraintOutcome> outcomes(const ConstraintList& list, const ConstraintSystem& system,
                                        const Diagnosis& diagnosis)
{
  const std::vector<DependencyGroups> groups = dependencyGroupsOf(system, diagnosis, list.constraints.size());
  std::vector<Index> rows(groups.size(), 0);
  for (const ConstraintRow& row : system.rows) ++rows[row.constraint];
  std::vector<std::vector<ConflictSet>> conflictSets = conflictSetsOf(list, system, groups, rows);
  std::vector<ConstraintOutcome> result(groups.size());
  for (std::size_t c = 0; c < groups.size(); ++c) {
    ConstraintOutcome& outcome = result[c];
    outcome.name = list.constraints[c].name;
    outcome.type = typeName(list.constraints[c]);
    outcome.rows = rows[c];
    outcome.status = statusOf(groups[c], rows[c], list.constraints[c].isEnabled);
    outcome.conflictSets = std::move(conflictSets[c]);
    if (outcome.status == ConstraintStatus::Redundant || outcome.status == ConstraintStatus::Conflicting) {
      outcome.gap = 0;
      ConstraintSet terms;
      for (const auto& [others, group] : groups[c]) {
        outcome.gap = std::max(*outcome.gap, group.gap.stableNorm());
        terms.insert(others.begin(), others.end());
        if (group.needsOwn) terms.insert(static_cast<Index>(c));
      }
      for (const Index term : terms) outcome.dependsOn.push_back(list.constraints[term].name);
    }
  }
  setLimits(result, system, diagnosis.limits);
  return result;
}

void setSensitivities(std::vector<ConstraintOutcome>& outcomes, const ConstraintSystem& system,
                      const Diagnosis& diagnosis, const std::vector<double>& ofRows)
{
  const auto raise = [&](Index row, double sensitivity) {
    std::optional<double>& largest = outcomes[system.rows[row].constraint].sensitivity;
    largest = std::max(largest.value_or(0), sensitivity);
  };
  for (std::size_t r = 0; r < ofRows.size(); ++r)
    if (diagnosis.status[r] == RowStatus::Independent) raise(static_cast<Index>(r), ofRows[r]);
  for (const auto& [dependency, gap] : diagnosis.dependent) {
    raise(dependency.row, 0);
    for (const Term& term : dependency.terms) raise(dependency.row, ofRows[term.index]);
  }
}

std::optional<MissedRow> setResiduals(Report& report, const ConstraintSystem& system, const Diagnosis& diagnosis,
                                      const std::vector<double>& residuals)
{
  setLimits(report.constraints, system, diagnosis.limits);
  std::optional<MissedRow> worst;
  double largest = 0;
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    ConstraintOutcome& outcome = report.constraints[system.rows[r].constraint];
    outcome.residual = std::max(outcome.residual.value_or(0), residuals[r]);
    if (diagnosis.status[r] == RowStatus::Conflicting) continue;
    if (outcome.status == ConstraintStatus::Independent) outcome.status = ConstraintStatus::Met;
    largest = std::max(largest, residuals[r]);
    const MissedRow row{system.rows[r].constraint, residuals[r], diagnosis.limits[r]};
    if (row.residual <= row.limit) continue;
    if (outcome.status != ConstraintStatus::Conflicting) outcome.status = ConstraintStatus::Missed;
    outcome.limit = std::min(*outcome.limit, row.limit);
    if (!worst || row.residual / row.limit > worst->residual / worst->limit) worst = row;
  }
  report.solve.maxResidual = largest;
  report.solve.maxResidualRelative = largest / report.mesh.bboxDiagonal;
  return worst;
}

bool setRoundedResiduals(Report& report, const DeformResult& result, const Weld& weld)
{
  const auto& [system, diagnosis, operators] = *result.details;
  const Positions stored = result.positions.cast<float>().cast<double>();
  return setResiduals(report, system, diagnosis, rowResiduals(system, weld, stored)).has_value();
}

Index countOf(const Report& report, ConstraintStatus status)
{
  return std::count_if(report.constraints.begin(), report.constraints.end(),
                       [&](const ConstraintOutcome& outcome) { return outcome.status == status; });
}

}  // namespace holdfast
