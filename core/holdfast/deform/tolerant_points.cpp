#include "holdfast/deform/tolerant_points.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include <holdfast/deform/feet_on_surfaces.h>
#include <holdfast/deform/tolerance_offsets.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/solve/allowed_places.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// A solution has three columns, each for a target of its own.
constexpr Index kAtOnce = 3;

// Where the reach of all points has more numbers, each choice of targets is followed by a solution instead.
constexpr Index kMostNumbersOfReach = 100'000'000;

/// The tolerant points that follow from no other rows of a part.
std::vector<Index> independentPoints(const ConstraintSystem& system, const AxisElimination& part)
{
  std::vector<Index> points;
  for (std::size_t i = 0; i < system.tolerant.size(); ++i)
    if (!std::ranges::binary_search(part.eliminated->dependencies, rowInPart(part, system.tolerant[i].row), {},
                                    &Dependency::row))
      points.push_back(static_cast<Index>(i));
  return points;
}

/// How the pull of each tolerant point grows with its own offset, the mean of all axes.
Eigen::VectorXd ownStiffness(const ConstraintSystem& system, const PlaceChoice& choice)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Index>(system.tolerant.size()));
  for (std::size_t p = 0; p < choice.stiffness.size(); ++p) {
    const double share = static_cast<double>(choice.eliminated.parts()[p].axes.count()) / 3;
    const PartStiffness& its = choice.stiffness[p];
    for (std::size_t c = 0; c < its.points.size(); ++c)
      result[its.points[c]] += share * its.matrix(static_cast<Index>(c), static_cast<Index>(c));
  }
  return result;
}

/// Makes the pulls along each axis of the frame.
class PullsOfAxes {
 public:
  PullsOfAxes(const ConstraintSystem& system, const PlaceChoice& choice, const Columns3& pulls)
      : system_(system), choice_(choice), pulls_(pulls * choice.eliminated.frame())
  {
    for (std::size_t i = 0; i < system.tolerant.size(); ++i) pointOf_[system.tolerant[i].row] = static_cast<Index>(i);
  }

  [[nodiscard]] std::array<AxisPull, 3> made() const
  {
    std::array<AxisPull, 3> result;
    const std::vector<AxisElimination>& parts = choice_.eliminated.parts();
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (std::size_t k = 0; k < 3; ++k)
        if (parts[p].axes[k]) result[k] = along(static_cast<Index>(k), parts[p], choice_.stiffness[p]);
    return result;
  }

 private:
  /// What a row asks of the displacement along an axis of the frame where all tolerant points have their stated
  /// targets, in diagonals.
  [[nodiscard]] double stated(Index row, Index axis) const
  {
    const auto point = pointOf_.find(row);
    const Vector3& shift = point == pointOf_.end() ? system_.rows[row].shift : system_.tolerant[point->second].shift;
    return choice_.eliminated.frame().col(axis).dot(shift) / choice_.diagonal;
  }

  [[nodiscard]] AxisPull along(Index axis, const AxisElimination& part, const PartStiffness& stiffness) const
  {
    const auto count = static_cast<Index>(stiffness.points.size());
    const auto points = static_cast<Index>(system_.tolerant.size());
    AxisPull result{&stiffness.matrix, Eigen::VectorXd(count), {}, Eigen::VectorXd::Zero(points), {}, {}};
    Eigen::VectorXd now(count);  // offsets at which the pulls are known
    std::map<Index, Index> columnOf;
    std::vector<Eigen::Triplet<double, int>> entries;
    for (Index c = 0; c < count; ++c) {
      const Index point = stiffness.points[c];
      const TolerantRow& tolerant = system_.tolerant[point];
      now[c] = choice_.eliminated.frame().col(axis).dot(system_.rows[tolerant.row].shift - tolerant.shift) /
               choice_.diagonal;
      result.pull[c] = pulls_(tolerant.row, axis);
      columnOf[tolerant.row] = c;
      entries.emplace_back(static_cast<int>(point), static_cast<int>(c), 1);
    }
    result.pull -= stiffness.matrix * now;
    std::vector<Eigen::Triplet<double, int>> fixed;
    std::vector<double> fixedTo;
    const auto wholeRow = [&](Index row) { return part.rows.empty() ? row : part.rows[row]; };
    for (const Dependency& dependency : part.eliminated->dependencies) {
      const Index row = wholeRow(dependency.row);
      const auto point = pointOf_.find(row);
      double implied = -stated(row, axis);
      std::vector<std::pair<Index, double>> terms;
      std::vector<Index> exact;
      for (const Term& term : dependency.terms) {
        const Index other = wholeRow(term.index);
        implied += term.coefficient * stated(other, axis);
        if (const auto column = columnOf.find(other); column != columnOf.end())
          terms.emplace_back(column->second, term.coefficient);
        else
          exact.push_back(other);
      }
      if (point != pointOf_.end()) {
        result.constant[point->second] = implied;
        result.constantBy[point->second] = std::move(exact);
        for (const auto& [column, coefficient] : terms)
          entries.emplace_back(static_cast<int>(point->second), static_cast<int>(column), coefficient);
      } else if (!terms.empty() && !dependency.isUndecided()) {
        for (const auto& [column, coefficient] : terms)
          fixed.emplace_back(static_cast<int>(fixedTo.size()), static_cast<int>(column), coefficient);
        fixedTo.push_back(-implied);
        exact.push_back(row);
        result.fixedBy.push_back(std::move(exact));
      }
    }
    result.offsets = SparseRows(points, count);
    result.offsets.setFromTriplets(entries.begin(), entries.end());
    result.fixed = SparseRows(static_cast<Index>(fixedTo.size()), count);
    result.fixed.setFromTriplets(fixed.begin(), fixed.end());
    result.fixedTo = Eigen::Map<const Eigen::VectorXd>(fixedTo.data(), static_cast<Index>(fixedTo.size()));
    return result;
  }

  const ConstraintSystem& system_;
  const PlaceChoice& choice_;
  Columns3 pulls_;                  // by coordinates of the frame
  std::map<Index, Index> pointOf_;  // of a row
};

}  // namespace

bool areOfSameRows(const std::vector<PartStiffness>& stiffness, const ConstraintSystem& system)
{
  return !stiffness.empty() && stiffness.front().rows == rowsOfTolerant(system);
}

std::vector<PartStiffness> stiffnessOf(const ConstraintSystem& system, const AxisSolvers& solvers,
                                       const EnergyMatrix& A, const ActedOn& actedOn, Progress& progress)
{
  std::vector<PartStiffness> result;
  const std::vector<AxisElimination>& parts = solvers.eliminated().parts();
  const auto most = static_cast<Index>(parts.size() * system.tolerant.size());
  const bool isKept = A.cols() * most <= kMostNumbersOfReach;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Elimination& elimination = parts[p].eliminated->elimination;
    PartStiffness& its =
        result.emplace_back(PartStiffness{rowsOfTolerant(system), independentPoints(system, parts[p]), {}});
    const auto count = static_cast<Index>(its.points.size());
    std::vector<Index> rows;
    for (const Index point : its.points) rows.push_back(rowInPart(parts[p], system.tolerant[point].row));
    progress.step(fmt::format("solving for each of {} points whose places are chosen", count));
    its.matrix.resize(count, count);
    if (isKept) its.reach.resize(A.cols(), count);
    const Columns3 atRest = Columns3::Zero(A.rows(), kAtOnce);
    for (Index first = 0; first < count; first += kAtOnce) {
      progress.proceed(static_cast<double>(first) / static_cast<double>(count));
      const Index columns = std::min(kAtOnce, count - first);
      Columns3 shifts = Columns3::Zero(static_cast<Index>(parts[p].eliminated->rows.size()), kAtOnce);
      for (Index c = 0; c < columns; ++c) shifts(rows[first + c], c) = 1;
      const Displacement unit = solvers.of(p).solve({std::move(shifts), {}}, atRest);
      const Columns3 pulls = elimination.multipliers(forcesAtUnknowns(A, actedOn, unit.u, atRest, 1));
      its.matrix.middleCols(first, columns) = pulls(rows, Eigen::all).leftCols(columns);
      if (!isKept) continue;
      its.reach.middleCols(first, columns) = unit.u.leftCols(columns);
      its.reachOfMultipliers.conservativeResize(unit.multipliers.rows(), count);
      its.reachOfMultipliers.middleCols(first, columns) = unit.multipliers.leftCols(columns);
    }
    its.matrix = (its.matrix + its.matrix.transpose().eval()) / 2;
  }
  return result;
}

std::vector<PartStiffness> looseStiffness(const ConstraintSystem& system, const EliminatedByAxes& eliminated)
{
  std::vector<PartStiffness> result;
  for (const AxisElimination& part : eliminated.parts()) {
    PartStiffness& its =
        result.emplace_back(PartStiffness{rowsOfTolerant(system), independentPoints(system, part), {}});
    const auto count = static_cast<Index>(its.points.size());
    its.matrix = Eigen::MatrixXd::Identity(count, count);
  }
  return result;
}

ChosenPlaces chooseTargets(ConstraintSystem& system, const PlaceChoice& choice, const Columns3& pulls)
{
  const Eigen::Matrix3d& frame = choice.eliminated.frame();
  const ToleranceUnits units{frame, choice.diagonal, choice.weightScale};
  const PullsOfAxes pullsOfAxes(system, choice, pulls);
  FeetOnSurfaces feet(system, ownStiffness(system, choice), choice.diagonal);
  ChosenOffsets chosen;
  Positions offsets;
  do {
    std::vector<AllowedOffset> allowed;
    for (std::size_t i = 0; i < system.tolerant.size(); ++i) {
      const TolerantRow& tolerant = system.tolerant[i];
      allowed.push_back(allowedOffset(tolerant, system.rows[tolerant.row].directions, units));
      feet.restrict(i, allowed.back());
    }
    chosen = chooseOffsets(pullsOfAxes.made(), allowed);
    offsets = choice.diagonal * chosen.offsets * frame.transpose();
  } while (feet.follow(system, offsets));
  takeOffsets(system, offsets);
  for (std::size_t i = 0; i < system.tolerant.size(); ++i) system.tolerant[i].isAtBound = chosen.isAtBound[i] != 0;
  ChosenPlaces places;
  places.notes = feet.notes(system);
  Contradictions& result = places.contradictions;
  for (const auto& [point, others] : chosen.contradicted) {
    if (point < 0) continue;  // a sum of rows that contradicts others is their conflict
    std::vector<Index>& rows = result[system.tolerant[point].row];
    for (const Index other : others) rows.push_back(other < 0 ? -1 - other : system.tolerant[other].row);
    rows = sortedOnce(std::move(rows));
  }
  return places;
}

Columns3 tolerantShifts(const ConstraintSystem& system)
{
  Columns3 shifts(static_cast<Index>(system.tolerant.size()), 3);
  for (Index i = 0; i < shifts.rows(); ++i) shifts.row(i) = system.rows[system.tolerant[i].row].shift;
  return shifts;
}

bool followTargets(const ConstraintSystem& system, const Columns3& before, const EliminatedByAxes& eliminated,
                   const std::vector<PartStiffness>& stiffness, Displacement& displacement)
{
  const Columns3 moves = tolerantShifts(system) - before;
  Index kept = 0;
  for (const PartStiffness& part : stiffness) {
    if (part.reach.rows() != displacement.u.rows() && !part.points.empty()) return false;
    kept += part.reachOfMultipliers.rows();
  }
  const bool hasMultipliers = kept == displacement.multipliers.rows();
  Index first = 0;
  for (std::size_t p = 0; p < stiffness.size(); ++p) {
    const auto& [rows, points, matrix, reach, reachOfMultipliers] = stiffness[p];
    const Columns3 its = eliminated.along(p, moves(points, Eigen::all));
    if (hasMultipliers)
      displacement.multipliers.middleRows(first, reachOfMultipliers.rows()) += reachOfMultipliers * its;
    first += reachOfMultipliers.rows();
    if (points.empty()) continue;
    const Columns3 inModel = eliminated.isOne() ? its : Columns3(its * eliminated.frame().transpose());
    parallelBlocks(displacement.u.rows(), [&](Index i) { displacement.u.row(i) += reach.row(i) * inModel; });
  }
  return true;
}

}  // namespace holdfast
