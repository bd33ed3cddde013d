#include "holdfast/document/constraint_drag.h"

#include <cassert>
#include <utility>

#include <Eigen/Geometry>

#include <holdfast/base/error.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/document/handle_restated.h>
#include <holdfast/document/own_axes.h>
#include <holdfast/geometry/centroid.h>
#include <holdfast/geometry/degree.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

/// The vertices of a handle in the order in which `placeHandle` wants them.
std::vector<Index> verticesOf(const HandleConstraint& handle, Selector& selector, const InputLocation& where)
{
  auto selected = selector.select(handle.select, below(where, ".select"));
  const auto* ids = std::get_if<VertexIds>(&handle.select.what);
  const bool isListed = std::holds_alternative<VertexTargets>(handle.motion) || !handle.rotations.empty();
  return ids && isListed ? ids->ids : selected;
}

Vector3 movedPlace(const Vector3& place, const RigidIncrement& increment)
{
  if (increment.degrees == 0) return place + increment.translation;
  const Eigen::AngleAxisd turn(increment.degrees * kDegree, increment.axis.normalized());
  return turn * (place - increment.pivot) + increment.pivot + increment.translation;
}

}  // namespace

ConstraintDrag::ConstraintDrag(const Model& model, const ConstraintList& list, std::span<const Index> constraints,
                               const std::string& source)
    : model_(&model), list_(list), source_(source)
{
  const SurfaceLocator locator = model.locator();
  Selector selector(model.mesh, model.solverMesh, locator);
  for (const Index c : constraints) {
    const Constraint& constraint = list.constraints[c];
    if (!constraint.isEnabled) continue;
    const InputLocation where = placeInList(source, c);
    if (const auto* point = std::get_if<PointConstraint>(&constraint.what)) {
      const SurfacePoint at = locator.locate(point->at, below(where, ".at")).point;
      const Vector3 rest = positionOf(at, model.mesh.positions);
      const auto* target = std::get_if<Target>(&point->to);
      points_.push_back({c, at, rest, target ? target->place : Vector3(rest + std::get<Move>(point->to).shift)});
    } else if (const auto* handle = std::get_if<HandleConstraint>(&constraint.what)) {
      handles_.push_back({c, rowsOf(model.mesh.positions, verticesOf(*handle, selector, where)), Vector3::Zero(), {}});
    }
  }
  surroundings_.diagonal = model.solverMesh.diagonal;
  if (!handles_.empty()) surroundings_.fixedCenter = centerOfFixed(model, list, selector, source);
  for (DraggedHandle& handle : handles_) {
    const auto& what = std::get<HandleConstraint>(list.constraints[handle.constraint].what);
    const InputLocation where = placeInList(source, handle.constraint);
    handle.center = centroid(placeHandle(what, handle.rest, surroundings_, where).places);
    handle.turn = rotationOfMotion(what, handle.rest, surroundings_, where);
  }
}

Vector3 ConstraintDrag::center() const
{
  assert(!isEmpty());
  Vector3 sum = Vector3::Zero();
  for (const DraggedPoint& point : points_) sum += point.place;
  for (const DraggedHandle& handle : handles_) sum += handle.center;
  return sum / static_cast<double>(points_.size() + handles_.size());
}

Eigen::Matrix3d ConstraintDrag::axes(const Positions& positions) const
{
  assert(!isEmpty());
  const bool isPoint =
      handles_.empty() || (!points_.empty() && points_.front().constraint < handles_.front().constraint);
  if (isPoint) return surfaceAxes(*model_, points_.front().point, positions);
  const DraggedHandle& dragged = handles_.front();
  const auto& handle = std::get<HandleConstraint>(list_.constraints[dragged.constraint].what);
  if (const auto* motion = std::get_if<FrameMotion>(&handle.motion)) return axesOf(motion->to);
  return rotationMatrix(dragged.turn.axis, dragged.turn.degrees) * principalAxes(dragged.rest);
}

HandleConstraint ConstraintDrag::nextFrame(DraggedHandle& dragged, const RigidIncrement& increment) const
{
  const InputLocation where = placeInList(source_, dragged.constraint);
  const auto& start = std::get<HandleConstraint>(list_.constraints[dragged.constraint].what);
  HandleConstraint moved = composed(start, increment, dragged.rest, surroundings_, where);
  try {
    moved = followed(moved, dragged.turn, dragged.rest, surroundings_, where);
    dragged.turn = rotationOfMotion(moved, dragged.rest, surroundings_, where);
  } catch (const InputError&) {
    // It cannot turn about what is fixed there; the list is refused with the reason, and the next frame goes on.
  }
  return moved;
}

ConstraintList ConstraintDrag::movedBy(const RigidIncrement& increment)
{
  ConstraintList moved = list_;
  for (const DraggedPoint& dragged : points_) {
    auto& point = std::get<PointConstraint>(moved.constraints[dragged.constraint].what);
    const bool isShift = increment.degrees == 0;
    if (auto* move = std::get_if<Move>(&point.to))
      move->shift = isShift ? Vector3(move->shift + increment.translation)
                            : Vector3(movedPlace(dragged.place, increment) - dragged.rest);
    else
      std::get<Target>(point.to).place = movedPlace(dragged.place, increment);
  }
  for (DraggedHandle& dragged : handles_) moved.constraints[dragged.constraint].what = nextFrame(dragged, increment);
  return moved;
}

}  // namespace holdfast
