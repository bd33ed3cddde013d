#include "holdfast/widgets/marks/mark_set.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include <holdfast/constraints/selector.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/marks/evenly_spread.h>

namespace holdfast {
namespace {

MarkKind kindOf(std::size_t corners)
{
  constexpr std::array kKinds{MarkKind::Selection, MarkKind::Vertex, MarkKind::Edge, MarkKind::Face};
  return kKinds[std::min(corners, kKinds.size() - 1)];
}

MarkKind kindOf(const ConstraintRow& row)
{
  if (row.kind == RowKind::Region) return MarkKind::Rigid;
  if (row.kind == RowKind::Mirrored) return MarkKind::Selection;
  return row.kind == RowKind::Relative ? MarkKind::Relative : kindOf(static_cast<std::size_t>(row.corners));
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

Index heaviest(std::span<const Term> terms)
{
  return std::ranges::max_element(terms, {}, &Term::coefficient)->index;
}

/// At the first of two partners: no place of the surface lies between them.
ConstraintMark markOfPartner(const ConstraintRow& row, const Model& model, const Positions& positions)
{
  const Index unknown = row.terms.front().index;
  const Index vertex = model.solverMesh.weld.firstVertexOf[unknown];
  const Vector3 place = positions.row(vertex);
  ConstraintMark mark{place, place};
  mark.rest = model.mesh.positions.row(vertex);
  mark.nearest = unknown;
  return mark;
}

/// A row that says how one place lies to another acts on the one.
ConstraintMark markOf(const ConstraintRow& row, const Model& model, const Positions& positions)
{
  const Weld& weld = model.solverMesh.weld;
  const auto [acts, refers] = placesOf(row, weld, positions);
  const Side rest = placesOf(row, weld, model.mesh.positions).acts;
  ConstraintMark mark{acts.sum, row.target};
  mark.rest = rest.sum;
  mark.nearest = heaviest(row.terms);
  if (row.kind == RowKind::Position) return mark;
  if (row.kind == RowKind::Mirrored) return markOfPartner(row, model, positions);
  mark.place = acts.sum / acts.weight;
  mark.target = mark.place + (row.target - (acts.sum + refers.sum)) / acts.weight;
  mark.rest = rest.sum / rest.weight;
  if (row.kind == RowKind::Relative) mark.other = refers.sum / refers.weight;
  return mark;
}

class DisabledMarks {
 public:
  DisabledMarks(const Model& model, const Positions& positions, KnownPlaces& places)
      : model_(model),
        positions_(positions),
        places_(places),
        locator_(model.locator()),
        selector_(model.mesh, model.solverMesh, locator_)
  {
  }

  /// `place` is that of the constraint in its list.
  std::vector<ConstraintMark> of(const Constraint& constraint, Index place)
  {
    return std::visit([&](const auto& what) { return marksOf(what, place); }, constraint.what);
  }

 private:
  std::vector<ConstraintMark> marksOf(const FixedConstraint& fixed, Index place)
  {
    return ofSelection(fixed.select, MarkKind::Selection, place);
  }

  std::vector<ConstraintMark> marksOf(const HandleConstraint& handle, Index place)
  {
    return ofSelection(handle.select, MarkKind::Selection, place);
  }

  std::vector<ConstraintMark> marksOf(const RigidConstraint& rigid, Index place)
  {
    return ofSelection(rigid.select, MarkKind::Rigid, place);
  }

  std::vector<ConstraintMark> marksOf(const SlideConstraint& slide, Index place)
  {
    return ofSelection(slide.select, MarkKind::Selection, place);
  }

  static std::vector<ConstraintMark> marksOf(const MirrorConstraint& /*mirror*/, Index /*place*/) { return {}; }

  std::vector<ConstraintMark> marksOf(const PointConstraint& point, Index place)
  {
    const SurfacePoint at = located(point.at);
    ConstraintMark mark = markAt(at, kindOf(at.terms.size()), place);
    mark.target = placeOf(point, mark.rest);
    return {mark};
  }

  std::vector<ConstraintMark> marksOf(const RelativeConstraint& relative, Index place)
  {
    return ofEnds(relative, place);
  }

  std::vector<ConstraintMark> marksOf(const CoincidentConstraint& coincident, Index place)
  {
    return ofEnds(coincident, place);
  }

  std::vector<ConstraintMark> ofEnds(const auto& what, Index place) const
  {
    ConstraintMark mark = markAt(located(what.from), MarkKind::Relative, place);
    mark.other = positionOf(located(what.to), positions_);
    return {mark};
  }

  [[nodiscard]] SurfacePoint located(const SurfaceLocation& location) const { return locator_.locate(location, {}); }

  [[nodiscard]] ConstraintMark markAt(const SurfacePoint& at, MarkKind kind, Index constraint) const
  {
    const Vector3 place = positionOf(at, positions_);
    ConstraintMark mark{place, place,      ConstraintStatus::Disabled,
                        kind,  constraint, positionOf(at, model_.mesh.positions)};
    mark.nearest = model_.solverMesh.weld.unknownOf[heaviest(at.terms)];
    return mark;
  }

  std::vector<ConstraintMark> ofSelection(const Selection& selection, MarkKind kind, Index constraint)
  {
    std::vector<ConstraintMark> marks;
    for (const Index vertex :
         places_.vertices(constraint, selection, [&] { return selector_.select(selection, {}); })) {
      marks.push_back(markAt(SurfacePoint{{{vertex, 1}}}, kind, constraint));
      marks.back().unknown = model_.solverMesh.weld.unknownOf[vertex];
    }
    return marks;
  }

  const Model& model_;
  const Positions& positions_;
  KnownPlaces& places_;
  SurfaceLocator locator_;
  Selector selector_;
};

/// Returns those of `group` that are drawn where there are too many.
std::vector<Index> thinned(const std::vector<ConstraintMark>& marks, const std::vector<Index>& group)
{
  Positions rest(static_cast<Index>(group.size()), 3);
  for (Index k = 0; k < rest.rows(); ++k) rest.row(k) = marks[group[k]].rest;
  std::vector<Index> kept;
  for (const Index k : evenlySpread(rest, kMostDots)) kept.push_back(group[k]);
  return kept;
}

/// Tells whether both lists hold the same places with the same statuses: then the same marks are drawn.
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
  std::vector<ConstraintMark> marks;
  marks.reserve(system.rows.size());
  for (std::size_t r = 0; r < system.rows.size(); ++r) {
    const ConstraintRow& row = system.rows[r];
    if (row.terms.empty()) continue;
    const ConstraintStatus status = rowStatus(*deformation.details, static_cast<Index>(r));
    // All of the surface may be mirrored: only what is amiss is marked, and what lies on the plane.
    if (row.kind == RowKind::Mirrored && !isOff(status)) continue;
    ConstraintMark mark = markOf(row, model, deformation.positions);
    mark.status = status;
    mark.kind = kindOf(row);
    mark.constraint = row.constraint;
    if (row.kind == RowKind::Mirrored)
      std::tie(mark.unknown, mark.reference) = std::pair(row.terms[0].index, row.terms[1].index);
    else if (!isSinglePoint(mark.kind))
      for (const Term& term : row.terms) (term.coefficient < 0 ? mark.reference : mark.unknown) = term.index;
    marks.push_back(std::move(mark));
  }
  return marks;
}

std::vector<ConstraintMark> constraintMarks(const Model& model, const ConstraintList& list,
                                            const DeformResult& deformation, KnownPlaces& places)
{
  std::vector<ConstraintMark> marks = constraintMarks(model, deformation);
  DisabledMarks disabled(model, deformation.positions, places);
  for (std::size_t k = 0; k < list.constraints.size(); ++k) {
    if (list.constraints[k].isEnabled) continue;
    const std::vector<ConstraintMark> some = disabled.of(list.constraints[k], static_cast<Index>(k));
    marks.insert(marks.end(), some.begin(), some.end());
  }
  return marks;
}

std::vector<ConstraintMark> constraintMarks(const Model& model, const ConstraintList& list,
                                            const DeformResult& deformation)
{
  KnownPlaces places;
  return constraintMarks(model, list, deformation, places);
}

bool isOff(ConstraintStatus status)
{
  return status == ConstraintStatus::Conflicting || status == ConstraintStatus::Missed;
}

RegionLooks regionLooks(const Model& model, const std::vector<ConstraintMark>& marks)
{
  // From the least serious one: a later one counts.
  constexpr std::array kOrder{ConstraintStatus::Disabled, ConstraintStatus::Independent, ConstraintStatus::Redundant,
                              ConstraintStatus::Met,      ConstraintStatus::Missed,      ConstraintStatus::Conflicting};
  const auto orderOf = [&](const ConstraintMark& mark) {
    return std::ranges::find(kOrder, mark.status) - kOrder.begin();
  };
  std::map<Index, std::ptrdiff_t> gravest;
  for (const ConstraintMark& mark : marks)
    if (mark.unknown >= 0) gravest[mark.constraint] = std::max(gravest[mark.constraint], orderOf(mark));
  RegionLooks looks(static_cast<std::size_t>(model.solverMesh.unknownCount()), 0);
  for (const ConstraintMark& mark : marks) {
    if (mark.unknown < 0) continue;
    const ConstraintStatus status = kOrder[static_cast<std::size_t>(gravest[mark.constraint])];
    const bool isRigidAndMet = mark.kind == MarkKind::Rigid && status == ConstraintStatus::Met;
    const std::size_t look = isRigidAndMet ? kRegionLooks - 1 : static_cast<std::size_t>(status);
    for (const Index unknown : {mark.unknown, mark.reference})
      if (unknown >= 0) looks[unknown] |= static_cast<std::uint8_t>(1U << look);
  }
  return looks;
}

std::vector<Index> drawnMarks(const std::vector<ConstraintMark>& marks, const std::vector<char>& isCovered)
{
  std::map<ConstraintStatus, std::vector<Index>> dots;
  std::vector<Index> drawn;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const bool isOneOfMany = !isSinglePoint(marks[k].kind) && !isOff(marks[k].status);
    if (isOneOfMany && !isCovered.empty() && marks[k].unknown >= 0 && isCovered[marks[k].unknown] != 0) continue;
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

std::shared_ptr<const MarkSet> markSet(const Model& model, std::vector<ConstraintMark> marks,
                                       const std::shared_ptr<const MarkSet>& before,
                                       std::vector<ConstraintGuide> guides)
{
  if (marks.empty() && guides.empty()) return std::make_shared<const MarkSet>();
  if (before && areDrawnAlike(marks, before->marks))
    return std::make_shared<const MarkSet>(MarkSet{std::move(marks), before->drawn, before->looks, std::move(guides)});
  auto looks = std::make_shared<const RegionLooks>(regionLooks(model, marks));
  std::vector<char> isCovered(looks->size(), 0);
  for (const auto& [a, b, c] : model.solverMesh.triangles)
    if (((*looks)[a] & (*looks)[b] & (*looks)[c]) != 0) isCovered[a] = isCovered[b] = isCovered[c] = 1;
  std::vector<Index> drawn = drawnMarks(marks, isCovered);
  return std::make_shared<const MarkSet>(
      MarkSet{std::move(marks), std::move(drawn), std::move(looks), std::move(guides)});
}

}  // namespace holdfast
