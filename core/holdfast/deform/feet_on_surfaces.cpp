#include "holdfast/deform/feet_on_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <holdfast/surface/guide_surface.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

// After so many steps all points are damped more and more, so that the search ends.
constexpr int kFreeSteps = 30;
constexpr int kMostSteps = 50;

// Feet that move by less, in diagonals, have arrived. A point on two surfaces at once needs so many digits.
constexpr double kSettled = 1e-12;

// Feet that move by more, in diagonals, in the last free step are named.
constexpr double kUnsettled = 1e-5;

// Without these points the surface may be free to move as a whole: this weight keeps it near then.
constexpr double kFirstWeight = 1e-9;

// Steps that turn back are damped more and more, others less and less.
constexpr double kMoreDamping = 3;
constexpr double kLessDamping = 0.5;

/// The part of an offset from the foot, with length `along` its direction, that a tolerance allows.
struct NearestAllowed {
  double along;

  double operator()(const Exactly& /*exactly*/) const { return 0; }
  double operator()(const WithinBall& ball) const { return std::clamp(along, -ball.radius, ball.radius); }
  double operator()(const WithinSlab& slab) const { return std::clamp(along, slab.low, slab.high); }
  double operator()(const auto& /*other*/) const { return along; }
};

/// Some points of a constraint.
struct Count {
  Index some = 0;
  Index all = 0;
};

/// Of each constraint.
using Counts = std::map<Index, Count>;

void addNotes(std::vector<ConstraintNote>& notes, const Counts& counts, const char* kind, const char* what)
{
  for (const auto& [constraint, count] : counts)
    if (count.some > 0)
      notes.push_back(
          {constraint, kind, fmt::format("has {} of {} {}", count.some, counted(count.all, "point"), what)});
}

}  // namespace

FeetOnSurfaces::FeetOnSurfaces(const ConstraintSystem& system, const Eigen::VectorXd& stiffness, double diagonal)
    : diagonal_(diagonal)
{
  for (std::size_t i = 0; i < system.tolerant.size(); ++i)
    if (system.tolerant[i].surface != nullptr) searches_.push_back({i, stiffness[static_cast<Index>(i)]});
}

void FeetOnSurfaces::restrict(std::size_t point, AllowedOffset& allowed) const
{
  const auto search = std::ranges::lower_bound(searches_, point, {}, &Search::point);
  if (search == searches_.end() || search->point != point) return;
  if (steps_ == 0) {
    allowed = {.weight = search->stiffness * kFirstWeight};
    return;
  }
  allowed.damping = search->stiffness * std::max(search->damping, std::pow(kMoreDamping, steps_ - kFreeSteps));
}

bool FeetOnSurfaces::follow(ConstraintSystem& system, Positions& offsets)
{
  if (searches_.empty()) return false;
  double moved = 0;
  for (Search& search : searches_) {
    Vector3 offset = offsets.row(static_cast<Index>(search.point));
    follow(search, system, offset);
    offsets.row(static_cast<Index>(search.point)) = offset;
    moved = std::max(moved, search.step.norm() / diagonal_);
  }
  ++steps_;
  if (steps_ == kFreeSteps)
    for (Search& search : searches_) search.isUnsettled = search.step.norm() > kUnsettled * diagonal_;
  return steps_ == 1 || (moved > kSettled && steps_ < kMostSteps);
}

void FeetOnSurfaces::follow(Search& search, ConstraintSystem& system, Vector3& offset)
{
  TolerantRow& tolerant = system.tolerant[search.point];
  const Vector3 place = tolerant.target + offset;
  const Foot foot = tolerant.surface->footOf(place);
  const Vector3 step = foot.place - tolerant.target;
  search.damping *= step.dot(search.step) < 0 ? kMoreDamping : kLessDamping;
  search.step = step;
  search.isOnBorder = foot.isOnBorder;
  tolerant.target += step;
  tolerant.shift += step;
  const bool isExact = std::holds_alternative<Exactly>(tolerant.within);
  const Vector3 normal = isExact || foot.distance == 0 ? foot.normal : Vector3((place - foot.place) / foot.distance);
  system.rows[tolerant.row].directions = RowDirections::along(normal);
  offset = std::visit(NearestAllowed{foot.distance}, tolerant.within) * normal;
}

std::vector<ConstraintNote> FeetOnSurfaces::notes(const ConstraintSystem& system) const
{
  Counts unsettled;
  Counts onBorder;
  for (const Search& search : searches_) {
    const Index constraint = system.rows[system.tolerant[search.point].row].constraint;
    for (const auto& [counts, isOne] : {std::pair(&unsettled, search.isUnsettled), {&onBorder, search.isOnBorder}}) {
      Count& count = (*counts)[constraint];
      ++count.all;
      if (isOne) ++count.some;
    }
  }
  std::vector<ConstraintNote> result;
  addNotes(result, unsettled, "unsettled_places",
           "on the surface whose place of the least energy jumps about; smooth the surface, or give a tolerance");
  addNotes(result, onBorder, "on_border",
           "at the border of the surface, which they would leave; leave out what the surface does not cover");
  return result;
}

}  // namespace holdfast
