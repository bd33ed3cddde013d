#include "holdfast/document/handle_restated.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <holdfast/constraints/handle_drag.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

// Logs of one rotation, computed in two ways; radians.
constexpr double kSameRotation = 1e-9;

HandleConstraint validated(HandleConstraint handle, const HandleSetting& setting)
{
  if (const auto error = validateHandle(handle)) throw InputError(below(setting.where, error->key), error->reason);
  return handle;
}

/// Returns the place to which the motion takes the centroid, before the translation; none where it stays.
std::optional<Vector3> centroidAfter(const HandleConstraint& handle, const Eigen::Matrix3d& R,
                                     const HandleSetting& setting)
{
  if (const auto* targets = std::get_if<VertexTargets>(&handle.motion)) {
    Positions places(static_cast<Index>(targets->places.size()), 3);
    for (Index k = 0; k < places.rows(); ++k) places.row(k) = targets->places[k].transpose();
    return centroid(setting.once(places));
  }
  const auto* turn = std::get_if<AxisRotation>(&handle.motion);
  if (turn == nullptr || !turn->center) return std::nullopt;
  return Vector3(*turn->center + R * handle.scale.cwiseProduct(centroid(setting) - *turn->center));
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
  if (fixed.empty()) return std::nullopt;
  for (Index& v : fixed) v = model.solverMesh.weld.unknownOf[v];
  const Positions places = model.solverMesh.rest(sortedOnce(std::move(fixed)), Eigen::all);
  return centroid(places);
}

// Variances that differ by less than this share of the largest have no axis that a user would expect.
constexpr double kAlike = 0.05;

/// Tells whether the face has every vertex that the point hangs on, or one in the same place.
bool holds(const std::vector<int>& unknownOf, std::span<const int> face, const SurfacePoint& point)
{
  return std::all_of(point.terms.begin(), point.terms.end(), [&](const Term& term) {
    return std::ranges::any_of(face, [&](Index corner) { return unknownOf[corner] == unknownOf[term.index]; });
  });
}

}  // namespace

HandleConstraint byFrames(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (std::holds_alternative<FrameMotion>(handle.motion)) return handle;
  const AxisAngle turn = rotationOfMotion(handle, setting);
  const Eigen::Matrix3d R = rotationMatrix(turn.axis, turn.degrees);
  const Eigen::Matrix3d from = isUniform(handle.scale) ? principalAxes(setting.once(setting.rest))
                                                       : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d to = R * from;
  FrameMotion frames{
      {std::nullopt, from.col(0), from.col(1)}, {centroidAfter(handle, R, setting), to.col(0), to.col(1)}, 0};
  const std::optional<Index> turns = wholeTurns(frames, rotationLog(turn.axis, turn.degrees));
  if (!turns)
    throw InputError(
        setting.where,
        fmt::format("the handle turns by {} degrees, nearly whole turns, so the frames would have the same axes and no "
                    "axis to turn about; let it turn about an axis",
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
  result.scale.setOnes();
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
    settings.push_back({model.mesh.positions(vertices, Eigen::all), surroundings, where, vertices,
                        firstOfUnknowns(vertices, model.solverMesh.weld.unknownOf)});
  }
  return settings;
}

InputLocation placeInList(const std::string& source, Index constraint)
{
  return {source, 0, fmt::format("constraints[{}]", constraint)};
}

Eigen::Matrix3d axesAbout(const Vector3& direction)
{
  const Vector3 z = unitOrZero(direction);
  if (z.isZero(0)) return Eigen::Matrix3d::Identity();
  Index across = 0;
  z.cwiseAbs().minCoeff(&across);
  const Vector3 x = (Vector3::Unit(across) - z[across] * z).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return axes;
}

Eigen::Matrix3d surfaceAxes(const Model& model, const SurfacePoint& point, const Positions& positions)
{
  Vector3 sum = Vector3::Zero();
  for (Index f = 0; f < model.mesh.faces.size(); ++f)
    if (holds(model.solverMesh.weld.unknownOf, model.mesh.faces[f], point))
      sum += areaVector(positions, model.mesh.faces[f]);
  return axesAbout(sum);
}

Eigen::Matrix3d principalAxes(const Positions& places)
{
  const Positions arms = places.rowwise() - centroid(places).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(arms.transpose() * arms);
  const Vector3& variances = solver.eigenvalues();
  const double flat = variances[1] - variances[0];
  const double slender = variances[2] - variances[1];
  if (!(std::max(flat, slender) > kAlike * variances[2])) return Eigen::Matrix3d::Identity();
  const Vector3 axis = solver.eigenvectors().col(flat > slender ? 0 : 2);
  Index along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  return axesAbout(axis[along] < 0 ? Vector3(-axis) : axis);
}

}  // namespace holdfast
