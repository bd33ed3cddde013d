#include "holdfast/document/constraint_drag.h"

#include <algorithm>

#include <holdfast/constraints/selector.h>
#include <holdfast/document/handle_restated.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

Vector3 movedPlace(const Vector3& place, const RigidIncrement& increment)
{
  if (increment.degrees == 0) return place + increment.translation;
  const Eigen::AngleAxisd turn(increment.degrees * kDegree, increment.axis.normalized());
  return turn * (place - increment.pivot) + increment.pivot + increment.translation;
}

void drag(Target& target, const Vector3& place, const Vector3& /*rest*/, const RigidIncrement& increment)
{
  target.place = movedPlace(place, increment);
}

void drag(Move& move, const Vector3& place, const Vector3& rest, const RigidIncrement& increment)
{
  const bool isShift = increment.degrees == 0;
  move.shift = isShift ? Vector3(move.shift + increment.translation) : Vector3(movedPlace(place, increment) - rest);
}

/// Takes a place and a direction with it; where there is no place, `rest` moves.
void drag(std::optional<Vector3>& point, Vector3& direction, const Vector3& rest, const RigidIncrement& increment)
{
  point = movedPlace(point.value_or(rest), increment);
  if (increment.degrees != 0)
    direction = Eigen::AngleAxisd(increment.degrees * kDegree, increment.axis.normalized()) * direction;
}

void drag(Coordinates& coordinates, const Vector3& place, const Vector3& /*rest*/, const RigidIncrement& increment)
{
  const Vector3 moved = movedPlace(place, increment);
  for (std::size_t k = 0; k < 3; ++k)
    if (coordinates.values[k]) coordinates.values[k] = moved[static_cast<Index>(k)];
}

void drag(OnPlane& plane, const Vector3& /*place*/, const Vector3& rest, const RigidIncrement& increment)
{
  drag(plane.point, plane.normal, rest, increment);
}

void drag(OnLine& line, const Vector3& /*place*/, const Vector3& rest, const RigidIncrement& increment)
{
  drag(line.point, line.direction, rest, increment);
}

/// The surface stays where it is.
void drag(OnMesh& /*surface*/, const Vector3& /*place*/, const Vector3& /*rest*/, const RigidIncrement& /*increment*/)
{
}

/// Vertices that each have a plane of their own move it along the normal.
void drag(SlideConstraint& slide, const RigidIncrement& increment)
{
  if (auto* const plane = std::get_if<OnPlane>(&slide.on)) {
    if (!plane->point && increment.degrees == 0)
      plane->offset += plane->normal.stableNormalized().dot(increment.translation);
    else
      drag(*plane, {}, plane->point.value_or(increment.pivot), increment);
  }
  if (auto* const line = std::get_if<OnLine>(&slide.on)) drag(*line, {}, *line->point, increment);
}

/// Tells whether the plane or the line of a slide is one that a drag can move.
bool canDrag(const SlideConstraint& slide)
{
  const auto* const line = std::get_if<OnLine>(&slide.on);
  return !slide.together && (std::holds_alternative<OnPlane>(slide.on) || (line != nullptr && line->point));
}

/// Tells whether a row places a point. The rows of a region have no corners.
bool isRowOfPoint(const ConstraintRow& row)
{
  return row.kind == RowKind::Position && row.corners > 0 && row.directions.areAll();
}

}  // namespace

ConstraintDrag::ConstraintDrag(const Model& model, const ConstraintList& list, std::span<const Index> constraints,
                               const std::string& source)
    : model_(&model), list_(list)
{
  std::vector<Index> handles;
  for (const Index c : constraints) {
    const Constraint& constraint = list.constraints[c];
    if (!constraint.isEnabled) continue;
    if (std::holds_alternative<HandleConstraint>(constraint.what)) handles.push_back(c);
    if (const auto* const slide = std::get_if<SlideConstraint>(&constraint.what); slide != nullptr && canDrag(*slide)) {
      Selector selector(model.mesh, model.solverMesh, model.locator());
      const std::vector<Index> vertices = selector.select(slide->select, below(placeInList(source, c), ".select"));
      const Vector3 rest = centroid(model.mesh.positions(vertices, Eigen::all));
      const auto* const plane = std::get_if<OnPlane>(&slide->on);
      guides_.push_back({c, plane != nullptr ? plane->placeFrom(rest) : std::get<OnLine>(slide->on).placeFrom(rest),
                         slide->directions()});
    }
    const auto* point = std::get_if<PointConstraint>(&constraint.what);
    if (point == nullptr || std::holds_alternative<OnMesh>(point->to)) continue;
    const SurfacePoint at = model.locator().locate(point->at, below(placeInList(source, c), ".at"));
    const Vector3 rest = positionOf(at, model.mesh.positions);
    points_.push_back({c, at, rest, placeOf(*point, rest), point->directions()});
  }
  if (handles.empty()) return;
  std::vector<HandleSetting> settings = settingsOf(model, list, handles, source);
  for (std::size_t k = 0; k < handles.size(); ++k) {
    DraggedHandle handle{handles[k], std::move(settings[k]), Vector3::Zero(), {}};
    handle.center = centroid(handle.setting.once(placeHandle(startOf(handle), handle.setting).places));
    handle.turn = rotationOfMotion(startOf(handle), handle.setting);
    handles_.push_back(std::move(handle));
  }
}

Vector3 ConstraintDrag::center() const
{
  assert(!isEmpty());
  Vector3 sum = Vector3::Zero();
  for (const DraggedPoint& point : points_) sum += point.place;
  for (const DraggedHandle& handle : handles_) sum += handle.center;
  for (const DraggedGuide& guide : guides_) sum += guide.place;
  return sum / static_cast<double>(count());
}

RowDirections ConstraintDrag::directions() const
{
  if (count() != 1 || hasHandles()) return {};
  return points_.empty() ? guides_.front().directions : points_.front().directions;
}

Eigen::Matrix3d ConstraintDrag::axes(const Positions& positions) const
{
  assert(!isEmpty());
  if (const RowDirections its = directions(); !its.areAll()) return axesAbout(its.axis());
  if (points_.empty() && handles_.empty()) return axesAbout(guides_.front().directions.axis());
  const bool isPoint =
      handles_.empty() || (!points_.empty() && points_.front().constraint < handles_.front().constraint);
  if (isPoint) return surfaceAxes(*model_, points_.front().point, positions);
  const DraggedHandle& dragged = handles_.front();
  if (const auto* motion = std::get_if<FrameMotion>(&startOf(dragged).motion)) return axesOf(motion->to);
  return rotationMatrix(dragged.turn.axis, dragged.turn.degrees) *
         principalAxes(dragged.setting.once(dragged.setting.rest));
}

const HandleConstraint& ConstraintDrag::startOf(const DraggedHandle& dragged) const
{
  return std::get<HandleConstraint>(list_.constraints[dragged.constraint].what);
}

HandleConstraint ConstraintDrag::nextFrame(DraggedHandle& dragged, const RigidIncrement& increment) const
{
  HandleConstraint moved = composed(startOf(dragged), increment, dragged.setting);
  try {
    moved = followed(moved, dragged.turn, dragged.setting);
    dragged.turn = rotationOfMotion(moved, dragged.setting);
  } catch (const InputError&) {
    // It cannot turn about what is fixed there; the list is refused with the reason, and the next frame goes on.
  }
  return moved;
}

std::optional<SharedPlace> sharedPlace(const ConstraintSystem& system, std::span<const Index> constraints)
{
  const auto rowOf = [&](Index constraint) {
    return std::ranges::find_if(
        system.rows, [&](const ConstraintRow& row) { return isRowOfPoint(row) && row.constraint == constraint; });
  };
  if (constraints.size() < 2) return std::nullopt;
  const auto first = rowOf(constraints.front());
  if (first == system.rows.end()) return std::nullopt;
  SharedPlace shared;
  for (const ConstraintRow& row : system.rows) {
    if (!isRowOfPoint(row) || row.terms != first->terms) continue;
    shared.constraints.push_back(row.constraint);
    shared.mean += row.target;
  }
  if (!std::ranges::all_of(constraints, [&](Index c) { return std::ranges::binary_search(shared.constraints, c); }))
    return std::nullopt;
  shared.mean /= static_cast<double>(shared.constraints.size());
  return shared;
}

ConstraintList ConstraintDrag::movedBy(const RigidIncrement& increment)
{
  ConstraintList moved = list_;
  for (const DraggedPoint& dragged : points_) {
    auto& point = std::get<PointConstraint>(moved.constraints[dragged.constraint].what);
    std::visit([&](auto& to) { drag(to, dragged.place, dragged.rest, increment); }, point.to);
  }
  for (const DraggedGuide& dragged : guides_)
    drag(std::get<SlideConstraint>(moved.constraints[dragged.constraint].what), increment);
  for (DraggedHandle& dragged : handles_) moved.constraints[dragged.constraint].what = nextFrame(dragged, increment);
  return moved;
}

std::vector<Index> ConstraintDrag::handleVertices() const
{
  std::vector<Index> all;
  for (const auto& [constraint, setting, center, turn] : handles_)
    all.insert(all.end(), setting.vertices.begin(), setting.vertices.end());
  return all;
}

Positions ConstraintDrag::handlePlaces(const ConstraintList& moved) const
{
  Positions all(static_cast<Index>(handleVertices().size()), 3);
  Index row = 0;
  for (const DraggedHandle& dragged : handles_) {
    const auto& handle = std::get<HandleConstraint>(moved.constraints[dragged.constraint].what);
    const Positions places = placeHandle(handle, dragged.setting).places;
    all.middleRows(row, places.rows()) = places;
    row += places.rows();
  }
  return all;
}

}  // namespace holdfast
