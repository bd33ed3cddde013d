#include "holdfast/deform/tolerant_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include <holdfast/deform/feet_on_surfaces.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/solve/allowed_places.h>
#include <holdfast/solve/offset_bound.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

// A solution has three columns, each for a target of its own.
constexpr Index kAtOnce = 3;

// Where the reach of all points has more numbers, each choice of targets is followed by a solution instead.
constexpr Index kMostNumbersOfReach = 100'000'000;

/// Of a row of the whole system: its place in a part.
Index rowInPart(const AxisElimination& part, Index row)
{
  if (part.rows.empty()) return row;
  return std::ranges::lower_bound(part.rows, row) - part.rows.begin();
}

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

/// `directions` by coordinates of the frame.
RowDirections inFrame(const RowDirections& directions, const Eigen::Matrix3d& frame)
{
  if (directions.areAll()) return directions;
  const Vector3 axis = frame.transpose() * directions.axis();
  return directions.areAlongAxis() ? RowDirections::along(axis) : RowDirections::across(axis);
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

std::vector<Index> rowsOfPoints(const ConstraintSystem& system)
{
  std::vector<Index> rows;
  rows.reserve(system.tolerant.size());
  for (const TolerantRow& tolerant : system.tolerant) rows.push_back(tolerant.row);
  return rows;
}

struct AllowedBy {
  const Eigen::Matrix3d& frame;
  double diagonal;
  double weightScale;
  RowDirections directions;  // by coordinates of the frame

  AllowedOffset operator()(const Exactly& /*exactly*/) const { return {.directions = directions, .isZero = true}; }
  AllowedOffset operator()(const WithinBall& ball) const
  {
    return {.directions = directions, .radius = ball.radius / diagonal};
  }
  AllowedOffset operator()(const WithinBox& box) const
  {
    AllowedOffset result;
    for (Index k = 0; k < 3; ++k)
      result.slabs.push_back({frame.row(k).transpose(), -box.half[k] / diagonal, box.half[k] / diagonal});
    return result;
  }
  AllowedOffset operator()(const WithinSlab& slab) const
  {
    const Vector3 normal =
        slab.normal ? Vector3(frame.transpose() * slab.normal->stableNormalized()) : directions.axis();
    return {.directions = directions, .slabs = {{normal, slab.low / diagonal, slab.high / diagonal}}};
  }
  AllowedOffset operator()(const Weighted& weighted) const
  {
    const double w = weighted.weight / weightScale;
    return {.directions = directions, .weight = w * w};
  }
};

/// Brings a place that is meant to lie within a tolerance there in doubles, too.
struct WithinInDoubles {
  const Vector3& target;
  const RowDirections& directions;

  /// Far from the origin doubles may lie farther apart than the radius: no more is promised there than their distance.
  Vector3 operator()(const WithinBall& ball, Vector3 offset) const
  {
    constexpr int kMostTries = 4;
    for (int k = 0; k < kMostTries && directions.held(Vector3(target + offset) - target).norm() > ball.radius; ++k)
      offset -= std::numeric_limits<double>::epsilon() * directions.held(offset);
    return offset;
  }
  Vector3 operator()(const WithinBox& box, const Vector3& offset) const
  {
    return offset.cwiseMax(-box.half).cwiseMin(box.half);
  }
  Vector3 operator()(const auto& /*other*/, const Vector3& offset) const { return offset; }
};

/// Gives each tolerant row the target at its offset (rows x 3, model units) from the stated one.
void takeOffsets(ConstraintSystem& system, const Positions& offsets)
{
  for (std::size_t i = 0; i < system.tolerant.size(); ++i) {
    const TolerantRow& tolerant = system.tolerant[i];
    ConstraintRow& row = system.rows[tolerant.row];
    const Vector3 offset = std::visit(
        [&](const auto& within) {
          return WithinInDoubles{tolerant.target, row.directions}(within, offsets.row(static_cast<Index>(i)));
        },
        tolerant.within);
    row.target = tolerant.target + offset;
    row.shift = tolerant.shift + offset;
  }
}

/// The bounds of a point along the axes of the frame.
using BoundsOfPoint = std::array<RowBound, 3>;

/// Each bound of such a point is along one axis, which `requireFewTolerant` of the list has seen to.
BoundsOfPoint boundsByAxis(const AllowedOffset& allowed)
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  BoundsOfPoint bounds;
  for (Index k = 0; k < 3; ++k) {
    RowBound& bound = bounds[static_cast<std::size_t>(k)] = {-kFar, kFar, 0};
    const double held = allowed.directions.held(Vector3::Unit(k)).norm();
    if (held > 0.5) bound.weight = allowed.weight;
    if (held > 0.5 && allowed.radius > 0) std::tie(bound.low, bound.high) = std::pair(-allowed.radius, allowed.radius);
    for (const AllowedSlab& slab : allowed.slabs) {
      if (slab.normal[k] > 0.5) bound = {std::max(bound.low, slab.low), std::min(bound.high, slab.high), bound.weight};
      if (slab.normal[k] < -0.5)
        bound = {std::max(bound.low, -slab.high), std::min(bound.high, -slab.low), bound.weight};
    }
  }
  return bounds;
}

/// What a pull could do between the bounds.
double workOf(const RowBound& bound, double pull)
{
  const bool isBounded = std::isfinite(bound.low) || std::isfinite(bound.high);
  return isBounded ? std::abs(pull) * roomBetween(bound.low, bound.high) : 0;
}

/// Chooses places along one axis after the other.
class SeparateChooser {
 public:
  SeparateChooser(ConstraintSystem& system, const SeparateChoice& choice)
      : system_(system), choice_(choice), eliminated_(choice.solvers.eliminated()), frame_(eliminated_.frame())
  {
    for (const TolerantRow& tolerant : system.tolerant) {
      const RowDirections directions = inFrame(system.rows[tolerant.row].directions, frame_);
      bounds_.push_back(boundsByAxis(
          std::visit(AllowedBy{frame_, choice.diagonal, choice.weightScale, directions}, tolerant.within)));
    }
  }

  std::string choose(Progress& progress)
  {
    const auto count = static_cast<Index>(bounds_.size());
    Positions offsets(count, 3);  // by coordinates of the frame, in diagonals
    for (Index i = 0; i < count; ++i)
      for (Index k = 0; k < 3; ++k) offsets(i, k) = withinBounds(boundOf(i, k).low, boundOf(i, k).high);
    takeOffsets(system_, choice_.diagonal * offsets * frame_.transpose());
    Columns3 shifts(static_cast<Index>(system_.rows.size()), 3);
    for (Index r = 0; r < shifts.rows(); ++r) shifts.row(r) = system_.rows[r].shift;
    std::vector<RowTargets> targets;
    for (Columns3& ofPart : eliminated_.takenApart(shifts)) targets.push_back({std::move(ofPart), {}});
    const Columns3 u = choice_.solvers.solve(targets, choice_.f).u;
    const Columns3 pulls = choice_.pullsAt(u) * frame_;
    const Columns3 inFrame = u * frame_ / choice_.diagonal;
    const Columns3 f = choice_.f * frame_ / choice_.diagonal;
    for (TolerantRow& tolerant : system_.tolerant) tolerant.isAtBound = false;
    for (std::size_t p = 0; p < choice_.places.parts.size(); ++p)
      for (Index k = 0; k < 3; ++k) {
        if (!eliminated_.parts()[p].axes[static_cast<std::size_t>(k)]) continue;
        BoundedStart start{inFrame.col(k), f.col(k), Eigen::VectorXd(count), 0};
        std::vector<RowBound> bounds;
        for (Index i = 0; i < count; ++i) {
          bounds.push_back(boundOf(i, k));
          start.targets[i] = frame_.col(k).dot(system_.tolerant[i].shift) / choice_.diagonal;
          start.work += workOf(bounds.back(), pulls(system_.tolerant[i].row, k));
        }
        const auto chosen = choice_.places.parts[p].offsetsOf(start, bounds, [&](int number) {
          progress.step(
              fmt::format("choosing the places of {} points, axis {} of 3: factorisation {}", count, k + 1, number));
        });
        if (!chosen) return chosen.failure;
        offsets.col(k) = chosen.value->offsets;
        for (Index i = 0; i < count; ++i)
          if (chosen.value->isAtBound[i] != 0) system_.tolerant[i].isAtBound = true;
      }
    takeOffsets(system_, choice_.diagonal * offsets * frame_.transpose());
    return {};
  }

 private:
  [[nodiscard]] const RowBound& boundOf(Index point, Index axis) const
  {
    return bounds_[static_cast<std::size_t>(point)][static_cast<std::size_t>(axis)];
  }

  ConstraintSystem& system_;
  const SeparateChoice& choice_;
  const EliminatedByAxes& eliminated_;
  const Eigen::Matrix3d& frame_;
  std::vector<BoundsOfPoint> bounds_;  // lengths in diagonals
};

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
  return !stiffness.empty() && stiffness.front().rows == rowsOfPoints(system);
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
        result.emplace_back(PartStiffness{rowsOfPoints(system), independentPoints(system, parts[p]), {}});
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
    PartStiffness& its = result.emplace_back(PartStiffness{rowsOfPoints(system), independentPoints(system, part), {}});
    const auto count = static_cast<Index>(its.points.size());
    its.matrix = Eigen::MatrixXd::Identity(count, count);
  }
  return result;
}

ChosenPlaces chooseTargets(ConstraintSystem& system, const PlaceChoice& choice, const Columns3& pulls)
{
  const Eigen::Matrix3d& frame = choice.eliminated.frame();
  const PullsOfAxes pullsOfAxes(system, choice, pulls);
  FeetOnSurfaces feet(system, ownStiffness(system, choice), choice.diagonal);
  ChosenOffsets chosen;
  Positions offsets;
  do {
    std::vector<AllowedOffset> allowed;
    for (std::size_t i = 0; i < system.tolerant.size(); ++i) {
      const TolerantRow& tolerant = system.tolerant[i];
      const RowDirections directions = inFrame(system.rows[tolerant.row].directions, frame);
      allowed.push_back(std::visit(AllowedBy{frame, choice.diagonal, choice.weightScale, directions}, tolerant.within));
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

SeparatePlaces separatePlaces(const ConstraintSystem& system, const EliminatedByAxes& eliminated,
                              std::shared_ptr<const EnergyMatrix> A, const std::vector<int>& ranks)
{
  SeparatePlaces places{rowsOfPoints(system), {}, {}};
  for (const AxisElimination& part : eliminated.parts()) {
    std::vector<Index> rows;
    for (const Index row : places.rows) rows.push_back(rowInPart(part, row));
    const auto isTolerant = [&](Index row) { return std::ranges::binary_search(rows, row); };
    for (const Dependency& dependency : part.eliminated->dependencies)
      if (isTolerant(dependency.row) ||
          std::ranges::any_of(dependency.terms, [&](const Term& term) { return isTolerant(term.index); })) {
        places.failure = fmt::format(
            "{} points have tolerances, and some of them follow from others. More than {} are solved only where none "
            "does; leave out points that lie on the same vertices",
            places.rows.size(), kMostTolerantPoints);
        return places;
      }
    places.parts.emplace_back(A, *part.eliminated, rows, ranks);
  }
  return places;
}

std::string chooseSeparately(ConstraintSystem& system, const SeparateChoice& choice, Progress& progress)
{
  return SeparateChooser(system, choice).choose(progress);
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
