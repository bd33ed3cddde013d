#include "holdfast/elimination/axis_elimination.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <holdfast/constraints/axis_systems.h>

namespace holdfast {
namespace {

/// `system` with the rows alone that hold in all directions; the others keep their places and ask for nothing.
ConstraintSystem withoutDirections(ConstraintSystem system)
{
  for (ConstraintRow& row : system.rows)
    if (!row.eliminatedDirections().areAll()) row.terms = {};
  return system;
}

/// A dependency of a part, by places of rows in the whole system.
Dependency inWhole(Dependency dependency, const std::vector<Index>& rows)
{
  dependency.row = rows[dependency.row];
  for (Term& term : dependency.terms) term.index = rows[term.index];
  return dependency;
}

/// What all parts say of the rows.
class JoinedDiagnosis {
 public:
  JoinedDiagnosis(const Eigen::Matrix3d& frame, std::size_t rowCount)
      : frame_(frame), independent_(rowCount, 0), conflicting_(rowCount, 0)
  {
    diagnosis_.isNearOrigin = true;
    diagnosis_.limits.assign(rowCount, 0);
  }

  void add(const std::vector<Index>& rows, Diagnosis its)
  {
    diagnosis_.isNearOrigin = diagnosis_.isNearOrigin && its.isNearOrigin;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (its.status[k] == RowStatus::Independent) independent_[rows[k]] = 1;
      if (its.status[k] == RowStatus::Conflicting) conflicting_[rows[k]] = 1;
      diagnosis_.limits[rows[k]] = std::max(diagnosis_.limits[rows[k]], its.limits[k]);
    }
    for (DependentRow& row : its.dependent)
      diagnosis_.dependent.push_back({inWhole(std::move(row.dependency), rows), frame_ * row.gap, row.isConflicting});
    std::ranges::move(its.targets, std::back_inserter(diagnosis_.targets));
  }

  [[nodiscard]] Diagnosis joined()
  {
    for (std::size_t r = 0; r < independent_.size(); ++r)
      diagnosis_.status.push_back(conflicting_[r] != 0   ? RowStatus::Conflicting
                                  : independent_[r] != 0 ? RowStatus::Independent
                                                         : RowStatus::Redundant);
    std::ranges::stable_sort(diagnosis_.dependent, {}, [](const DependentRow& some) { return some.dependency.row; });
    return std::move(diagnosis_);
  }

 private:
  const Eigen::Matrix3d& frame_;
  std::vector<char> independent_;  // of each row: it is so along some axes
  std::vector<char> conflicting_;
  Diagnosis diagnosis_;
};

}  // namespace

EliminatedByAxes::EliminatedByAxes(const ConstraintSystem& system, const SolverMesh& mesh, double tolerance)
    : frame_(commonFrame(system.rows).value_or(Eigen::Matrix3d::Identity())),
      rowCount_(static_cast<Index>(system.rows.size()))
{
  if (std::ranges::all_of(system.rows, [](const ConstraintRow& row) { return row.eliminatedDirections().areAll(); })) {
    inAllDirections_ = std::make_shared<const EliminatedConstraints>(eliminate(system, mesh, tolerance));
    parts_.push_back({std::bitset<3>(0b111), {}, inAllDirections_});
    return;
  }
  for (AxisSystem& some : axisSystems(system, frame_))
    parts_.push_back({some.axes, std::move(some.rows),
                      std::make_shared<const EliminatedConstraints>(eliminate(some.system, mesh, tolerance))});
  inAllDirections_ =
      system.rotated.empty()
          ? parts_.front().eliminated
          : std::make_shared<const EliminatedConstraints>(eliminate(withoutDirections(system), mesh, tolerance));
}

Index EliminatedByAxes::freeCount() const
{
  Index count = 0;
  for (const AxisElimination& part : parts_) count += part.eliminated->elimination.freeCount();
  return count;
}

std::vector<bool> EliminatedByAxes::isHeld() const
{
  std::vector<bool> result = parts_.front().eliminated->isHeld;
  for (const AxisElimination& part : parts_)
    for (std::size_t u = 0; u < result.size(); ++u) result[u] = result[u] && part.eliminated->isHeld[u];
  return result;
}

std::vector<Columns3> EliminatedByAxes::takenApart(const Columns3& ofRows) const
{
  if (isOne()) return {ofRows};
  std::vector<Columns3> result;
  for (std::size_t k = 0; k < parts_.size(); ++k) result.push_back(along(k, ofRows(parts_[k].rows, Eigen::all)));
  return result;
}

Columns3 EliminatedByAxes::along(std::size_t k, Columns3 values) const
{
  return isOne() ? std::move(values) : alongAxes(std::move(values), parts_[k].axes, frame_);
}

Columns3 EliminatedByAxes::joined(std::vector<Columns3> ofParts) const
{
  return isOne() ? std::move(ofParts.front()) : joinedAxes(std::move(ofParts), frame_);
}

std::vector<double> EliminatedByAxes::sensitivities() const
{
  if (isOne()) return parts_.front().eliminated->elimination.sensitivities();
  std::vector<double> result(static_cast<std::size_t>(rowCount_), 0);
  for (const AxisElimination& part : parts_) {
    const std::vector<double> its = part.eliminated->elimination.sensitivities();
    for (std::size_t k = 0; k < its.size(); ++k) result[part.rows[k]] = std::max(result[part.rows[k]], its[k]);
  }
  return result;
}

Columns3 EliminatedByAxes::multipliers(const Columns3& gradient) const
{
  if (isOne()) return parts_.front().eliminated->elimination.multipliers(gradient);
  std::vector<Columns3> ofParts;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Columns3 its = parts_[k].eliminated->elimination.multipliers(along(k, gradient));
    ofParts.push_back(Columns3::Zero(rowCount_, 3));
    ofParts.back()(parts_[k].rows, Eigen::all) = its;
  }
  return joined(std::move(ofParts));
}

Diagnosis diagnose(const EliminatedByAxes& eliminated, const ConstraintSystem& system, const SolverMesh& mesh,
                   std::vector<KnownGaps>& known)
{
  const std::vector<AxisElimination>& parts = eliminated.parts();
  known.resize(parts.size());
  if (eliminated.isOne()) return diagnose(*parts.front().eliminated, system, mesh, known.front());
  JoinedDiagnosis joined(eliminated.frame(), system.rows.size());
  const std::vector<AxisSystem> systems = axisSystems(system, eliminated.frame());
  for (std::size_t k = 0; k < parts.size(); ++k)
    joined.add(parts[k].rows, diagnose(*parts[k].eliminated, systems[k].system, mesh, known[k]));
  return joined.joined();
}

}  // namespace holdfast
