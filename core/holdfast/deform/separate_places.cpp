#include "holdfast/deform/separate_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <holdfast/deform/tolerance_offsets.h>
#include <holdfast/solve/offset_bound.h>

namespace holdfast {
namespace {

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
    const ToleranceUnits units{frame_, choice.diagonal, choice.weightScale};
    for (const TolerantRow& tolerant : system.tolerant)
      bounds_.push_back(boundsByAxis(allowedOffset(tolerant, system.rows[tolerant.row].directions, units)));
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

}  // namespace

SeparatePlaces separatePlaces(const ConstraintSystem& system, const EliminatedByAxes& eliminated,
                              std::shared_ptr<const EnergyMatrix> A)
{
  SeparatePlaces places{rowsOfTolerant(system), {}, {}};
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
    places.parts.emplace_back(A, *part.eliminated, rows);
  }
  return places;
}

std::string chooseSeparately(ConstraintSystem& system, const SeparateChoice& choice, Progress& progress)
{
  return SeparateChooser(system, choice).choose(progress);
}

}  // namespace holdfast
