#include "holdfast/widgets/marks/mark_set.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <holdfast/constraints/selector.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/marks/evenly_spread.h>

namespace holdfast {
namespace {

ConstraintStatus statusOf(RowStatus row, double residual, double limit)
{
  if (row == RowStatus::Conflicting) return ConstraintStatus::Conflicting;
  if (residual > limit) return ConstraintStatus::Missed;
  return row == RowStatus::Redundant ? ConstraintStatus::Redundant : ConstraintStatus::Met;
}

MarkKind kindOf(const SurfacePoint& point)
{
  constexpr std::array kKinds{MarkKind::Selection, MarkKind::Vertex, MarkKind::Edge, MarkKind::Face};
  return kKinds[std::min(point.terms.size(), kKinds.size() - 1)];
}

MarkKind kindOf(const ConstraintRow& row, const SurfacePoint& point)
{
  if (row.kind == RowKind::Region) return MarkKind::Rigid;
  return row.kind == RowKind::Relative ? MarkKind::Relative : kindOf(point);
}

/// Sums of weighted positions over the terms of one sign: where a row acts, and what it refers to.
struct Side {
  Vector3 sum = Vector3::Zero();
  double weight = 0;
};

struct RowPlaces {
  Side acts;
  Side refers;
};

RowPlaces placesOf(const ConstraintRow& row, const Weld& weld, const Positions& positions)
{
  RowPlaces places;
  for (const Term& term : row.terms) {
    Side& side = term.coefficient < 0 ? places.refers : places.acts;
    side.sum += term.coefficient * positions.row(weld.firstVertexOf[term.index]).transpose();
    side.weight += term.coefficient;
  }
  return places;
}

/// A row that says how one place lies to another acts on the one.
ConstraintMark markOf(const ConstraintRow& row, const Model& model, const Positions& positions)
{
  const Weld& weld = model.solverMesh.weld;
  const auto [acts, refers] = placesOf(row, weld, positions);
  const Side rest = placesOf(row, weld, model.mesh.positions).acts;
  ConstraintMark mark{acts.sum, row.target};
  mark.rest = rest.sum;
  if (row.kind == RowKind::Position) return mark;
  mark.place = acts.sum / acts.weight;
  mark.target = mark.place + (row.target - (acts.sum + refers.sum)) / acts.weight;
  mark.rest = rest.sum / rest.weight;
  if (row.kind == RowKind::Relative) mark.other = refers.sum / refers.weight;
  return mark;
}

/// The places of one disabled constraint. Throws `InputError` where it does not fit the mesh.
std::vector<DisabledPlace> placesOf(const Constraint& constraint, Index place, const Model& model,
                                    const SurfaceLocator& locator, Selector& selector)
{
  const auto located = [&](const SurfaceLocation& location) { return locator.locate(location, {}); };
  if (const auto* point = std::get_if<PointConstraint>(&constraint.what)) {
    const SurfacePoint at = located(point->at);
    const Target* const target = std::get_if<Target>(&point->to);
    const Vector3 to =
        target != nullptr ? target->place : positionOf(at, model.mesh.positions) + std::get<Move>(point->to).shift;
    return {{at, kindOf(at), place, to, {}}};
  }
  if (const auto* relative = std::get_if<RelativeConstraint>(&constraint.what))
    return {{located(relative->from), MarkKind::Relative, place, {}, located(relative->to)}};
  const auto* const rigid = std::get_if<RigidConstraint>(&constraint.what);
  const auto* const handle = std::get_if<HandleConstraint>(&constraint.what);
  const Selection& selection = rigid != nullptr    ? rigid->select
                               : handle != nullptr ? handle->select
                                                   : std::get<FixedConstraint>(constraint.what).select;
  const MarkKind kind = rigid != nullptr ? MarkKind::Rigid : MarkKind::Selection;
  std::vector<DisabledPlace> places;
  for (const Index vertex : selector.select(selection, {}))
    places.push_back({SurfacePoint{{{vertex, 1}}}, kind, place, {}, {}});
  return places;
}

/// Those of `group` that are drawn where there are too many.
std::vector<Index> thinned(const std::vector<ConstraintMark>& marks, const std::vector<Index>& group)
{
  Positions rest(static_cast<Index>(group.size()), 3);
  for (Index k = 0; k < rest.rows(); ++k) rest.row(k) = marks[group[k]].rest;
  std::vector<Index> kept;
  for (const Index k : evenlySpread(rest, kMostDots)) kept.push_back(group[k]);
  return kept;
}

/// Whether both lists hold the same places with the same statuses: then the same marks are drawn.
bool areDrawnAlike(const std::vector<ConstraintMark>& a, const std::vector<ConstraintMark>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ConstraintMark& p, const ConstraintMark& q) {
    return p.rest == q.rest && p.status == q.status && p.kind == q.kind;
  });
}

}  // namespace

std::vector<ConstraintMark> constraintMarks(const Model& model, const DeformResult& deformation)
{
  const ConstraintSystem& system = deformation.details->system;
  const std::vector<double> residuals = rowResiduals(system, model.solverMesh.weld, deformation.positions);
  std::vector<ConstraintMark> marks;
  marks.reserve(residuals.size());
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    const ConstraintRow& row = system.rows[r];
    if (row.terms.empty()) continue;
    ConstraintMark mark = markOf(row, model, deformation.positions);
    mark.status =
        statusOf(deformation.details->diagnosis.status[r], residuals[r], deformation.details->diagnosis.limits[r]);
    mark.kind = kindOf(row, system.points[row.constraint]);
    mark.constraint = row.constraint;
    marks.push_back(std::move(mark));
  }
  return marks;
}

std::vector<DisabledPlace> disabledPlaces(const Model& model, const ConstraintList& list)
{
  const SurfaceLocator locator = model.locator();
  std::optional<Selector> selector;
  std::vector<DisabledPlace> places;
  for (std::size_t k = 0; k < list.constraints.size(); ++k) {
    if (list.constraints[k].isEnabled) continue;
    if (!selector) selector.emplace(model.mesh, model.solverMesh, locator);
    try {
      for (DisabledPlace& place : placesOf(list.constraints[k], static_cast<Index>(k), model, locator, *selector))
        places.push_back(std::move(place));
    } catch (const InputError&) {
      // A disabled constraint may be unusable; the error comes when it is enabled.
      continue;
    }
  }
  return places;
}

std::vector<ConstraintMark> disabledMarks(const Model& model, const std::vector<DisabledPlace>& places,
                                          const Positions& positions)
{
  std::vector<ConstraintMark> marks;
  for (const DisabledPlace& disabled : places) {
    const Vector3 place = positionOf(disabled.at, positions);
    ConstraintMark mark{place, disabled.target.value_or(place), ConstraintStatus::Disabled, disabled.kind,
                        disabled.constraint};
    mark.rest = positionOf(disabled.at, model.mesh.positions);
    if (!disabled.to.terms.empty()) mark.other = positionOf(disabled.to, positions);
    marks.push_back(std::move(mark));
  }
  return marks;
}

std::vector<ConstraintMark> constraintMarks(const Model& model, const ConstraintList& list,
                                            const DeformResult& deformation)
{
  std::vector<ConstraintMark> marks = constraintMarks(model, deformation);
  for (ConstraintMark& mark : disabledMarks(model, disabledPlaces(model, list), deformation.positions))
    marks.push_back(std::move(mark));
  return marks;
}

bool isOff(ConstraintStatus status)
{
  return status == ConstraintStatus::Conflicting || status == ConstraintStatus::Missed;
}

std::vector<Index> drawnMarks(const std::vector<ConstraintMark>& marks)
{
  std::map<ConstraintStatus, std::vector<Index>> dots;
  std::vector<Index> drawn;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const bool isOneOfMany = !isSinglePoint(marks[k].kind) && !isOff(marks[k].status);
    (isOneOfMany ? dots[marks[k].status] : drawn).push_back(static_cast<Index>(k));
  }
  for (const auto& [status, group] : dots)
    for (const Index k : thinned(marks, group)) drawn.push_back(k);
  // Disabled marks hide no others.
  const auto gravity = [&](Index k) {
    return marks[k].status == ConstraintStatus::Disabled ? -1 : static_cast<int>(marks[k].status);
  };
  std::sort(drawn.begin(), drawn.end(),
            [&](Index a, Index b) { return std::pair(gravity(a), a) < std::pair(gravity(b), b); });
  return drawn;
}

std::shared_ptr<const MarkSet> markSet(std::vector<ConstraintMark> marks, const std::shared_ptr<const MarkSet>& before)
{
  std::vector<Index> drawn = before && areDrawnAlike(marks, before->marks) ? before->drawn : drawnMarks(marks);
  return std::make_shared<const MarkSet>(MarkSet{std::move(marks), std::move(drawn)});
}

}  // namespace holdfast
