#include "holdfast/deform/outcomes.h"

#include <atomic>
#include <map>
#include <tuple>

#include <holdfast/mesh/index_lists.h>

namespace holdfast {
namespace {

using ConstraintSet = std::vector<Index>;  // ascending

/// Rows of one constraint that depend on the same other constraints.
struct DependencyGroup {
  Index rows = 0;
  Index lastRow = -1;
  Vector3 lastGap = Vector3::Zero();  // that of the last row, along all axes along which it depends on the others
  Index worstRow = 0;
  Vector3 gap = Vector3::Zero();
  bool isConflict = false;
  bool needsOwn = false;              // depends on others of its own rows as well
  bool isMetByFoundRotations = true;  // all of its conflicting rows are
};

using DependencyGroups = std::map<ConstraintSet, DependencyGroup>;

/// The groups of every constraint with dependent rows, by the other constraints that they need.
std::map<Index, DependencyGroups> dependencyGroupsOf(const ConstraintSystem& system, const Diagnosis& diagnosis)
{
  std::map<Index, DependencyGroups> result;
  for (const auto& [dependency, gap, isConflicting] : diagnosis.dependent) {
    const Index own = system.rows[dependency.row].constraint;
    ConstraintSet others;
    if (const auto reasons = diagnosis.reasons.find(dependency.row); reasons != diagnosis.reasons.end())
      for (const Index row : reasons->second) others.push_back(system.rows[row].constraint);
    else
      for (const Term& term : dependency.terms) others.push_back(system.rows[term.index].constraint);
    others = sortedOnce(std::move(others));
    const bool needsOwn = std::erase(others, own) > 0;
    DependencyGroup& group = result[own][others];
    group.needsOwn = group.needsOwn || needsOwn;
    if (group.lastRow != dependency.row) {
      ++group.rows;
      group.lastRow = dependency.row;
      group.lastGap.setZero();
    }
    group.lastGap += gap;
    if (group.rows == 1 || group.lastGap.stableNorm() > group.gap.stableNorm()) {
      group.gap = group.lastGap;
      group.worstRow = dependency.row;
    }
    if (!isConflicting) continue;
    group.isConflict = true;
    if (!std::ranges::binary_search(diagnosis.metIfFound, dependency.row)) group.isMetByFoundRotations = false;
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
std::map<Index, Index> conflictCounts(const std::map<Index, DependencyGroups>& groups)
{
  std::map<Index, Index> counts;
  for (const auto& [own, its] : groups)
    for (const auto& [others, group] : its) {
      if (!group.isConflict) continue;
      ++counts[own];
      for (const Index other : others) ++counts[other];
    }
  return counts;
}

/// The constraint whose end would end most conflicts, at the price of the fewest rows, the later one of equals.
Index cheapest(Index own, const ConstraintSet& others, const std::map<Index, Index>& conflicts,
               const std::vector<ConstraintOutcome>& outcomes)
{
  const auto cost = [&](Index c) { return std::tuple(-conflicts.at(c), outcomes[c].rows, -c); };
  Index best = own;
  for (const Index other : others)
    if (cost(other) < cost(best)) best = other;
  return best;
}

/// The first names of `constraints`, no more than `most`.
std::vector<std::string> namesOf(const ConstraintSet& constraints, const ConstraintLabels& labels, std::size_t most)
{
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(constraints.size(), most); ++k) names.push_back(labels[constraints[k]].name);
  return names;
}

/// How many names are listed for each next constraint that follows from others.
std::size_t mostNames(std::size_t before)
{
  return before < kMostWithManyPartners ? kMostNamedPartners : kFewPartners;
}

/// Sets the sets with which each constraint conflicts or which it repeats, the largest gap first. A set that holds all
/// constraints of another one and more is left out. O(dependent rows times terms).
void setConflictSets(std::vector<ConstraintOutcome>& outcomes, const ConstraintLabels& labels,
                     const ConstraintSystem& system, std::map<Index, DependencyGroups>&& groups)
{
  for (auto& [own, its] : groups) keepSmallest(its);
  const std::map<Index, Index> conflicts = conflictCounts(groups);
  std::size_t count = 0;
  for (const auto& [own, its] : groups) {
    const std::size_t most = mostNames(count++);
    std::vector<ConflictSet>& sets = outcomes[own].conflictSets;
    for (const auto& [others, group] : its) {
      ConflictSet& set = sets.emplace_back();
      set.with = namesOf(others, labels, most);
      set.withCount = static_cast<Index>(others.size());
      set.rows = group.rows;
      set.gap = group.gap;
      set.isConflict = group.isConflict;
      if (!group.isConflict) continue;
      set.isMetByFoundRotations = group.isMetByFoundRotations;
      set.disable = labels[cheapest(own, others, conflicts, outcomes)].name;
      if (labels[own].hasTarget) set.consistentTarget = system.rows[group.worstRow].target - group.gap;
    }
    std::stable_sort(sets.begin(), sets.end(), [](const ConflictSet& x, const ConflictSet& y) {
      return x.gap.stableNorm() > y.gap.stableNorm();
    });
  }
}

/// The status, gap and names, no more than `most`, of a constraint with dependent rows. `hasIndependent`: others are
/// not.
void setDependencies(ConstraintOutcome& outcome, Index own, bool hasIndependent, const DependencyGroups& groups,
                     const ConstraintLabels& labels, std::size_t most)
{
  bool isConflicting = false;
  double gap = 0;
  ConstraintSet terms;
  for (const auto& [others, group] : groups) {
    isConflicting = isConflicting || group.isConflict;
    gap = std::max(gap, group.gap.stableNorm());
    terms.insert(terms.end(), others.begin(), others.end());
    if (group.needsOwn) terms.push_back(own);
  }
  if (!isConflicting && hasIndependent) return;
  outcome.status = isConflicting ? ConstraintStatus::Conflicting : ConstraintStatus::Redundant;
  outcome.gap = gap;
  terms = sortedOnce(std::move(terms));
  outcome.dependsOn = namesOf(terms, labels, most);
  outcome.dependsOnCount = static_cast<Index>(terms.size());
}

/// The limit of a constraint is the largest of its rows; none without rows.
std::optional<double> limitOf(const std::vector<double>& limits, Index first, Index end)
{
  if (first == end) return std::nullopt;
  return *std::max_element(limits.begin() + first, limits.begin() + end);
}

/// Before anything is solved: without residuals, and none of them met.
std::vector<ConstraintOutcome> unsolvedOutcomes(const DeformDetails& details)
{
  const ConstraintSystem& system = details.system;
  const ConstraintLabels& labels = *details.labels;
  std::vector<ConstraintOutcome> result(labels.size());
  const std::vector<std::optional<double>> largest = constraintSensitivities(details);
  std::vector<char> hasIndependent(result.size(), 0);
  forEachConstraint(system, static_cast<Index>(result.size()), [&](Index c, Index first, Index end) {
    const ConstraintLabel& label = labels[c];
    ConstraintOutcome& outcome = result[c];
    outcome.name = label.name;
    outcome.type = label.type;
    if (!label.isEnabled) return;
    outcome.rows = end - first;
    const auto begin = details.diagnosis.status.begin();
    hasIndependent[c] = std::find(begin + first, begin + end, RowStatus::Independent) != begin + end ? 1 : 0;
    outcome.status = ConstraintStatus::Independent;
    outcome.limit = limitOf(details.diagnosis.limits, first, end);
    outcome.sensitivity = largest[c];
    // An enabled constraint without rows, as a rigid region of one vertex, asks for nothing and holds.
    if (first == end) setDependencies(outcome, c, false, {}, labels, 0);
  });
  for (const NearPlace& near : system.nearPlaces) {
    std::optional<double>& distance = result[near.constraint].nearDistance;
    distance = std::max(distance.value_or(0), near.nearness.distance);
  }
  std::map<Index, DependencyGroups> groups = dependencyGroupsOf(system, details.diagnosis);
  std::size_t count = 0;
  for (const auto& [own, its] : groups)
    setDependencies(result[own], own, hasIndependent[own] != 0, its, labels, mostNames(count++));
  setConflictSets(result, labels, system, std::move(groups));
  return result;
}

/// Sets the residuals, and the status of constraints that were solved.
void setResiduals(std::vector<ConstraintOutcome>& outcomes, const DeformDetails& details,
                  const std::vector<double>& residuals)
{
  const Diagnosis& diagnosis = details.diagnosis;
  forEachConstraint(details.system, static_cast<Index>(outcomes.size()), [&](Index c, Index first, Index end) {
    ConstraintOutcome& outcome = outcomes[c];
    for (Index r = first; r < end; ++r) {
      outcome.residual = std::max(outcome.residual.value_or(0), residuals[r]);
      if (diagnosis.status[r] == RowStatus::Conflicting) continue;
      if (outcome.status == ConstraintStatus::Independent) outcome.status = ConstraintStatus::Met;
      if (residuals[r] <= diagnosis.limits[r]) continue;
      if (outcome.status != ConstraintStatus::Conflicting) outcome.status = ConstraintStatus::Missed;
      outcome.limit = std::min(*outcome.limit, diagnosis.limits[r]);
    }
  });
}

/// How far points with tolerances and weights are from their targets. What conflicts is not where it was to go.
void setDistances(std::vector<ConstraintOutcome>& outcomes, const DeformDetails& details)
{
  for (const TolerantRow& tolerant : details.system.tolerant) {
    const ConstraintRow& row = details.system.rows[tolerant.row];
    if (std::holds_alternative<Exactly>(tolerant.within)) continue;
    if (details.diagnosis.status[tolerant.row] == RowStatus::Conflicting) continue;
    ConstraintOutcome& outcome = outcomes[row.constraint];
    const double distance = row.directions.held(row.target - tolerant.target).stableNorm();
    outcome.offTarget = std::max(outcome.offTarget.value_or(0), distance);
    if (!std::holds_alternative<Weighted>(tolerant.within))
      outcome.isAtBound = outcome.isAtBound.value_or(false) || tolerant.isAtBound;
  }
}

/// The multiplier of a constraint is the sum of the lengths of those of its rows.
void setMultipliers(std::vector<ConstraintOutcome>& outcomes, const ConstraintSystem& system, const Columns3& ofRows)
{
  forEachConstraint(system, static_cast<Index>(outcomes.size()), [&](Index c, Index first, Index end) {
    double sum = 0;
    for (Index r = first; r < end; ++r) sum += ofRows.row(r).stableNorm();
    if (first < end) outcomes[c].multiplier = sum;
  });
}

ConstraintLabel labelOf(const Constraint& constraint)
{
  return {constraint.name, typeName(constraint), constraint.isEnabled, hasTarget(constraint)};
}

bool isLabelOf(const ConstraintLabel& label, const Constraint& constraint)
{
  return label.name == constraint.name && label.type == typeName(constraint) &&
         label.isEnabled == constraint.isEnabled && label.hasTarget == hasTarget(constraint);
}

}  // namespace

ConstraintOutcomes::ConstraintOutcomes(std::vector<ConstraintOutcome> outcomes)
{
  std::promise<std::vector<ConstraintOutcome>> made;
  made.set_value(std::move(outcomes));
  outcomes_ = made.get_future();
}

ConstraintOutcomes::ConstraintOutcomes(std::function<std::vector<ConstraintOutcome>()> make)
    : outcomes_(std::async(std::launch::deferred, std::move(make)))
{
}

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
    residuals[r] = row.directions.held(at - row.target).stableNorm();
  });
  return residuals;
}

std::shared_ptr<const ConstraintLabels> labelsOf(const ConstraintList& list,
                                                 std::shared_ptr<const ConstraintLabels> known)
{
  const std::vector<Constraint>& constraints = list.constraints;
  std::atomic<bool> isKnown = known != nullptr && known->size() == constraints.size();
  if (isKnown)
    parallelBlocks(static_cast<Index>(constraints.size()), [&](Index c) {
      if (!isLabelOf((*known)[c], constraints[c])) isKnown = false;
    });
  if (isKnown) return known;
  ConstraintLabels labels;
  labels.reserve(constraints.size());
  for (const Constraint& constraint : constraints) labels.push_back(labelOf(constraint));
  return std::make_shared<const ConstraintLabels>(std::move(labels));
}

std::vector<std::optional<double>> constraintSensitivities(const DeformDetails& details)
{
  const std::vector<ConstraintRow>& rows = details.system.rows;
  std::vector<std::optional<double>> result(details.labels->size());
  const auto raise = [&](Index row, double sensitivity) {
    std::optional<double>& largest = result[rows[row].constraint];
    largest = std::max(largest.value_or(0), sensitivity);
  };
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (details.diagnosis.status[r] == RowStatus::Independent)
      raise(static_cast<Index>(r), (*details.sensitivities)[r]);
  for (const auto& [dependency, gap, isConflicting] : details.diagnosis.dependent) {
    raise(dependency.row, 0);
    for (const Term& term : dependency.terms) raise(dependency.row, (*details.sensitivities)[term.index]);
  }
  return result;
}

std::vector<ConstraintOutcome> outcomes(const DeformDetails& details, const std::vector<double>& residuals)
{
  std::vector<ConstraintOutcome> result = unsolvedOutcomes(details);
  if (residuals.empty()) return result;
  setResiduals(result, details, residuals);
  setDistances(result, details);
  if (details.multipliers.valid()) setMultipliers(result, details.system, details.multipliers.get().ofRows);
  return result;
}

ConstraintStatus rowStatus(const DeformDetails& details, Index row)
{
  const RowStatus status = details.diagnosis.status[row];
  if (status == RowStatus::Conflicting) return ConstraintStatus::Conflicting;
  if (isMissed(details, row)) return ConstraintStatus::Missed;
  return status == RowStatus::Redundant ? ConstraintStatus::Redundant : ConstraintStatus::Met;
}

std::optional<MissedRow> setLargestResidual(Report& report, const DeformDetails& details,
                                            const std::vector<double>& residuals)
{
  const auto& [limits, status] = std::tie(details.diagnosis.limits, details.diagnosis.status);
  std::optional<MissedRow> worst;
  double largest = 0;
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    if (status[r] == RowStatus::Conflicting) continue;
    largest = std::max(largest, residuals[r]);
    if (residuals[r] <= limits[r]) continue;
    if (!worst || residuals[r] / limits[r] > worst->residual / worst->limit)
      worst = MissedRow{details.system.rows[r].constraint, residuals[r], limits[r]};
  }
  report.solve.maxResidual = largest;
  report.solve.maxResidualRelative = largest / report.mesh.bboxDiagonal;
  return worst;
}

bool setStoredResiduals(Report& report, const DeformResult& result, const Positions& stored, const Weld& weld)
{
  const std::vector<double> residuals = rowResiduals(result.details->system, weld, stored);
  report.constraints = outcomes(*result.details, residuals);
  return setLargestResidual(report, *result.details, residuals).has_value();
}

Index countOf(const Report& report, ConstraintStatus status)
{
  return std::count_if(report.constraints.begin(), report.constraints.end(),
                       [&](const ConstraintOutcome& outcome) { return outcome.status == status; });
}

}  // namespace holdfast
