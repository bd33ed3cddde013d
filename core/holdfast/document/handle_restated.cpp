#include "holdfast/document/handle_restated.h"

#include <algorithm>

#include <fmt/format.h>

#include <holdfast/constraints/handle_drag.h>
#include <holdfast/constraints/handle_validation.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/document/own_axes.h>
#include <holdfast/geometry/centroid.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

// Logs of one rotation, computed in two ways; radians.
constexpr double kSameRotation = 1e-9;

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

/// The centroid of all that the enabled fixed constraints hold, at rest; none where nothing is fixed.
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
  return centroid(model.mesh.positions(fixed, Eigen::all));
}

}  // namespace

HandleConstraint byFrames(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (std::holds_alternative<FrameMotion>(handle.motion)) return handle;
  const AxisAngle turn = rotationOfMotion(handle, setting);
  const Eigen::Matrix3d R = rotationMatrix(turn.axis, turn.degrees);
  const Eigen::Matrix3d from = principalAxes(setting.rest);
  const Eigen::Matrix3d to = R * from;
  FrameMotion frames{
      {std::nullopt, from.col(0), from.col(1)}, {centroidAfter(handle, R, setting.rest), to.col(0), to.col(1)}, 0};
  const std::optional<Index> turns = wholeTurns(frames, rotationLog(turn.axis, turn.degrees));
  if (!turns)
    throw InputError(
        setting.where,
        fmt::format("the handle turns by {} degrees, as good as whole turns, and frames that lie alike say "
                    "no axis; let it turn about an axis",
                    angleDegrees(rotationLog(turn.axis, turn.degrees))));
  frames.turns = *turns;
  HandleConstraint result = handle;
  result.motion = frames;
  return result;
}

HandleConstraint byTargets(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (std::holds_alternative<VertexTargets>(handle.motion)) return handle;
  const HandlePlacement before = placeHandle(handle, setting);
  VertexTargets targets;
  for (const auto& place : before.places.rowwise()) targets.places.emplace_back(place.transpose());
  HandleConstraint result = handle;
  result.motion = std::move(targets);
  result.translate.setZero();
  result = validated(std::move(result), setting);
  if ((placeHandle(result, setting).q - before.q).cwiseAbs().maxCoeff() > kSameRotation)
    result.rotations = withRotations(handle, setting).rotations;
  return result;
}

HandleConstraint withRotations(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (!handle.rotations.empty()) return handle;
  HandleConstraint result = handle;
  result.rotations.assign(static_cast<std::size_t>(setting.rest.rows()), rotationOfMotion(handle, setting));
  return validated(std::move(result), setting);
}

std::vector<HandleSetting> settingsOf(const Model& model, const ConstraintList& list, std::span<const Index> handles,
                                      const std::string& source)
{
  Selector selector(model.mesh, model.solverMesh, model.locator());
  const HandleSurroundings surroundings{centerOfFixed(model, list, selector, source), model.solverMesh.diagonal};
  std::vector<HandleSetting> settings;
  for (const Index index : handles) {
    const Selection& select = std::get<HandleConstraint>(list.constraints[index].what).select;
    const InputLocation where = placeInList(source, index);
    std::vector<Index> vertices = selector.select(select, below(where, ".select"));
    const auto* listed = std::get_if<VertexIds>(&select.what);
    if (listed != nullptr && listed->ids.size() == vertices.size()) vertices = listed->ids;
    settings.push_back({model.mesh.positions(vertices, Eigen::all), surroundings, where});
  }
  return settings;
}

HandleSetting settingOf(const Model& model, const ConstraintList& list, Index handle, const std::string& source)
{
  return settingsOf(model, list, {&handle, 1}, source).front();
}

InputLocation placeInList(const std::string& source, Index constraint)
{
  return {source, 0, fmt::format("constraints[{}]", constraint)};
}

}  // namespace holdfast
