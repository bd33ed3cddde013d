#include "holdfast/deform/outcomes.h"

#include <set>

#include <holdfast/deform/deform_details.h>

namespace holdfast {
namespace {

/// What the rows of one constraint add up to.
struct RowTally {
  Index rows = 0;
  Index redundant = 0;
  Index conflicting = 0;
  double gap = 0;
  std::set<Index> terms;  // constraints
};

std::vector<RowTally> tally(const ConstraintSystem& system, const Diagnosis& diagnosis, std::size_t constraintCount)
{
  std::vector<RowTally> tallies(constraintCount);
  for (const ConstraintRow& row : system.rows) ++tallies[row.constraint].rows;
  for (const auto& [dependency, gap] : diagnosis.dependent) {
    RowTally& own = tallies[system.rows[dependency.row].constraint];
    const bool isConflicting = diagnosis.status[dependency.row] == RowStatus::Conflicting;
    ++(isConflicting ? own.conflicting : own.redundant);
    own.gap = std::max(own.gap, gap.stableNorm());
    for (const Term& term : dependency.terms) own.terms.insert(system.rows[term.index].constraint);
  }
  return tallies;
}

/// An enabled constraint without rows, as a rigid region of one vertex, asks for nothing and holds.
ConstraintStatus statusOf(const RowTally& rows, bool isEnabled)
{
  if (!isEnabled) return ConstraintStatus::Disabled;
  if (rows.conflicting > 0) return ConstraintStatus::Conflicting;
  return rows.redundant == rows.rows ? ConstraintStatus::Redundant : ConstraintStatus::Independent;
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
  std::vector<double> residuals;
  residuals.reserve(system.rows.size());
  for (const ConstraintRow& row : system.rows) {
    Vector3 at = Vector3::Zero();
    for (const Term& term : row.terms)
      at += term.coefficient * positions.row(weld.firstVertexOf[term.index]).transpose();
    residuals.push_back((at - row.target).stableNorm());
  }
  return residuals;
}

std::vector<ConstraintOutcome> outcomes(const ConstraintList& list, const ConstraintSystem& system,
                                        const Diagnosis& diagnosis)
{
  const std::vector<RowTally> tallies = tally(system, diagnosis, list.constraints.size());
  std::vector<std::vector<ConflictSet>> conflictSets = conflictSetsOf(list, system, diagnosis);
  std::vector<ConstraintOutcome> result;
  for (std::size_t c = 0; c < list.constraints.size(); ++c) {
    ConstraintOutcome outcome;
    outcome.name = list.constraints[c].name;
    outcome.type = typeName(list.constraints[c]);
    outcome.rows = tallies[c].rows;
    outcome.status = statusOf(tallies[c], list.constraints[c].isEnabled);
    outcome.conflictSets = std::move(conflictSets[c]);
    if (outcome.status == ConstraintStatus::Redundant || outcome.status == ConstraintStatus::Conflicting) {
      outcome.gap = tallies[c].gap;
      for (const Index term : tallies[c].terms) outcome.dependsOn.push_back(list.constraints[term].name);
    }
    result.push_back(std::move(outcome));
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
