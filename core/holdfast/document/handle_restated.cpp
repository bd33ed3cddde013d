#include "holdfast/document/handle_restated.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <holdfast/constraints/handle_drag.h>
#include <holdfast/constraints/handle_validation.h>
#include <holdfast/document/own_axes.h>
#include <holdfast/geometry/centroid.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

using std::numbers::pi;

// A log shorter than this has lost three digits of its axis, and whole turns about it would show that.
constexpr double kLeastAxisOfFrames = 1e-3;
// Doubles count up to here one by one.
constexpr double kMostTurns = 9e15;
// Logs of one rotation, computed in two ways; radians.
constexpr double kSameRotation = 1e-9;

AxisAngle turnOf(const HandleConstraint& handle, const HandleSetting& setting)
{
  return rotationOfMotion(handle, setting.rest, setting.surroundings, setting.where);
}

HandlePlacement placed(const HandleConstraint& handle, const HandleSetting& setting)
{
  return placeHandle(handle, setting.rest, setting.surroundings, setting.where);
}

HandleConstraint validated(HandleConstraint handle, const HandleSetting& setting)
{
  if (const auto error = validateHandle(handle)) throw InputError(below(setting.where, error->key), error->reason);
  return handle;
}

/// Where the motion takes the centroid, before the translation; none where it stays.
std::optional<Vector3> centroidAfter(const HandleConstraint& handle, const Eigen::Matrix3d& R, const Positions& rest)
{
  if (const auto* targets = std::get_if<VertexTargets>(&handle.motion)) {
    Positions places(static_cast<Index>(targets->places.size()), 3);
    for (Index k = 0; k < places.rows(); ++k) places.row(k) = targets->places[k].transpose();
    return centroid(places);
  }
  const auto* turn = std::get_if<AxisRotation>(&handle.motion);
  if (turn == nullptr || !turn->center) return std::nullopt;
  return Vector3(*turn->center + R * (centroid(rest) - *turn->center));
}

/// The whole turns about the axis of the frames that make the log of their rotation `q`.
Index wholeTurns(const FrameMotion& frames, const Vector3& q, const InputLocation& where)
{
  const Vector3 shortest = rotationLog(Eigen::Matrix3d(axesOf(frames.to) * axesOf(frames.from).transpose()));
  const double turns = (q - shortest).dot(shortest.normalized()) / pi;
  if (q.norm() > pi / 2 && (shortest.norm() < kLeastAxisOfFrames || std::abs(turns) > kMostTurns))
    throw InputError(where, fmt::format("the handle turns by {} degrees, as good as whole turns, and frames that lie "
                                        "alike say no axis; let it turn about an axis",
                                        angleDegrees(q)));
  return std::llround(turns);
}

}  // namespace

HandleConstraint byFrames(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (std::holds_alternative<FrameMotion>(handle.motion)) return handle;
  const AxisAngle turn = turnOf(handle, setting);
  const Eigen::Matrix3d R = rotationMatrix(turn.axis, turn.degrees);
  const Eigen::Matrix3d from = principalAxes(setting.rest);
  const Eigen::Matrix3d to = R * from;
  FrameMotion frames{
      {std::nullopt, from.col(0), from.col(1)}, {centroidAfter(handle, R, setting.rest), to.col(0), to.col(1)}, 0};
  frames.turns = wholeTurns(frames, rotationLog(turn.axis, turn.degrees), setting.where);
  HandleConstraint result = handle;
  result.motion = frames;
  return result;
}

HandleConstraint byTargets(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (std::holds_alternative<VertexTargets>(handle.motion)) return handle;
  const HandlePlacement before = placed(handle, setting);
  VertexTargets targets;
  for (const auto& place : before.places.rowwise()) targets.places.emplace_back(place.transpose());
  HandleConstraint result = handle;
  result.motion = std::move(targets);
  result.translate.setZero();
  result = validated(std::move(result), setting);
  if ((placed(result, setting).q - before.q).cwiseAbs().maxCoeff() > kSameRotation)
    result.rotations = withRotations(handle, setting).rotations;
  return result;
}

HandleConstraint withRotations(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (!handle.rotations.empty()) return handle;
  HandleConstraint result = handle;
  result.rotations.assign(static_cast<std::size_t>(setting.rest.rows()), turnOf(handle, setting));
  return validated(std::move(result), setting);
}

HandleSetting settingOf(const Model& model, const ConstraintList& list, Index index, const std::string& source)
{
  const SurfaceLocator locator = model.locator();
  Selector selector(model.mesh, model.solverMesh, locator);
  const auto& handle = std::get<HandleConstraint>(list.constraints[index].what);
  const InputLocation where = placeInList(source, index);
  const std::vector<Index> selected = selector.select(handle.select, below(where, ".select"));
  const auto* listed = std::get_if<VertexIds>(&handle.select.what);
  const bool isInOrder = listed != nullptr && listed->ids.size() == selected.size();
  return {rowsOf(model.mesh.positions, isInOrder ? listed->ids : selected),
          {centerOfFixed(model, list, selector, source), model.solverMesh.diagonal},
          where};
}

InputLocation placeInList(const std::string& source, Index constraint)
{
  return {source, 0, fmt::format("constraints[{}]", constraint)};
}

Positions rowsOf(const Positions& positions, const std::vector<Index>& vertices)
{
  return positions(vertices, Eigen::all);
}

std::optional<Vector3> centerOfFixed(const Model& model, const ConstraintList& list, Selector& selector,
                                     const std::string& source)
{
  std::vector<Index> fixed;
  for (std::size_t c = 0; c < list.constraints.size(); ++c) {
    const auto* what = std::get_if<FixedConstraint>(&list.constraints[c].what);
    if (!what || !list.constraints[c].isEnabled) continue;
    const auto selected = selector.select(what->select, below(placeInList(source, static_cast<Index>(c)), ".select"));
    fixed.insert(fixed.end(), selected.begin(), selected.end());
  }
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  if (fixed.empty()) return std::nullopt;
  return centroid(rowsOf(model.mesh.positions, fixed));
}

}  // namespace holdfast
