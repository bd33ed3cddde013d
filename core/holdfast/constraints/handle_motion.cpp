#include "holdfast/constraints/handle_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include <holdfast/geometry/rotation_fit.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

/// The motion p -> R (p - from) + to, whose rotation has the log q.
struct RigidMotion {
  Eigen::Matrix3d R;
  Vector3 q;
  Vector3 from;
  Vector3 to;

  /// Then by `translate`.
  [[nodiscard]] HandlePlacement place(const Positions& rest, const Vector3& translate) const
  {
    HandlePlacement result{rest, q.transpose().replicate(rest.rows(), 1)};
    for (Index k = 0; k < rest.rows(); ++k)
      result.places.row(k) = (R * (rest.row(k).transpose() - from) + to + translate).transpose();
    return result;
  }
};

/// The vertices of a handle at rest, scaled. Where a factor is 1, coordinates along its axis keep their bits.
Positions scaledRest(const HandleConstraint& handle, const HandleSetting& setting)
{
  if (handle.scale == Vector3::Ones()) return setting.rest;
  const auto* turn = std::get_if<AxisRotation>(&handle.motion);
  const auto* frames = std::get_if<FrameMotion>(&handle.motion);
  std::optional<Vector3> center;
  if (turn != nullptr) center = turn->center;
  if (frames != nullptr) center = frames->from.origin;
  const Eigen::Matrix3d axes = frames == nullptr ? Eigen::Matrix3d::Identity() : axesOf(frames->from);
  const Eigen::Matrix3d growth = axes * (handle.scale - Vector3::Ones()).asDiagonal() * axes.transpose();
  const Positions arms = setting.rest.rowwise() - center.value_or(centroid(setting)).transpose();
  return setting.rest + arms * growth;
}

/// A unit vector is along a direction where what is across it is shorter than this.
constexpr double kAlong = 1e-8;

/// The half turn about the axis across `direction` that is nearest to `axis`, where there is one.
std::optional<Eigen::Quaterniond> halfTurnAcross(const Vector3& direction, const Vector3& axis)
{
  const Vector3 a = direction.stableNormalized();
  const Vector3 unit = axis.stableNormalized();
  const Vector3 across = unit - a.dot(unit) * a;
  if (across.norm() <= kAlong) return std::nullopt;
  const Vector3 v = across.normalized();
  return Eigen::Quaterniond(0, v.x(), v.y(), v.z());
}

struct Placer {
  const Positions& rest;
  const Vector3& translate;
  const HandleSetting& setting;

  HandlePlacement operator()(std::monostate) const
  {
    return {rest.rowwise() + translate.transpose(), Positions::Zero(rest.rows(), 3)};
  }

  HandlePlacement operator()(const AxisRotation& turn) const
  {
    const Vector3 center = turn.center.value_or(centroid(setting));
    const RigidMotion motion{rotationMatrix(turn.axis, turn.degrees), rotationLog(turn.axis, turn.degrees), center,
                             center};
    return motion.place(rest, translate);
  }

  HandlePlacement operator()(const RotationAboutFixed& turn) const
  {
    const Vector3 own = centroid(setting);
    const Vector3 before = own - fixedCenter();
    const Vector3 after = before + translate;
    requireDirection(before, "at rest");
    requireDirection(after, "after \"translate\"");
    const Eigen::Quaterniond rotation = rotationFromTo(before, after, turn.near);
    const Vector3 q =
        turn.near ? rotationLogNear(rotation, rotationLog(turn.near->axis, turn.near->degrees)) : rotationLog(rotation);
    return RigidMotion{rotation.toRotationMatrix(), q, own, own}.place(rest, translate);
  }

  HandlePlacement operator()(const FrameMotion& motion) const
  {
    const Eigen::Matrix3d R = axesOf(motion.to) * axesOf(motion.from).transpose();
    const Vector3 shortest = rotationLog(R);
    const Vector3 q =
        motion.turns == 0
            ? shortest
            : Vector3(shortest + shortest.normalized() * std::numbers::pi * static_cast<double>(motion.turns));
    const Vector3 from = motion.from.origin.value_or(centroid(setting));
    return RigidMotion{R, q, from, motion.to.origin.value_or(from)}.place(rest, translate);
  }

  HandlePlacement operator()(const VertexTargets& targets) const
  {
    Positions places(rest.rows(), 3);
    for (Index k = 0; k < places.rows(); ++k) places.row(k) = (targets.places[k] + translate).transpose();
    requireRange(places);
    const RotationFit fit = fitRotation(setting.once(rest), setting.once(places));
    return {places, rotationLog(fit.R).transpose().replicate(places.rows(), 1), fit.isDetermined};
  }

  /// Sums of so many coordinates are doubles.
  void requireRange(const Positions& places) const
  {
    const double largest = std::max(places.cwiseAbs().maxCoeff(), rest.cwiseAbs().maxCoeff());
    if (!places.allFinite() || !std::isfinite(2 * largest * static_cast<double>(places.rows())))
      throw InputError(setting.where, "the handle goes to coordinates that are too large for doubles; bring it closer");
  }

 private:
  [[nodiscard]] Vector3 fixedCenter() const
  {
    if (!setting.surroundings.fixedCenter)
      fail(R"(nothing is fixed that the handle could turn about; add a constraint of type "fixed", enable one, or say )"
           R"(how the handle turns by "rotate")");
    return *setting.surroundings.fixedCenter;
  }

  [[nodiscard]] Eigen::Quaterniond rotationFromTo(const Vector3& before, const Vector3& after,
                                                  const std::optional<AxisAngle>& near) const
  {
    const DirectionTurn shortest = shortestRotation(before, after);
    if (shortest.isDetermined) return shortest.rotation;
    const auto halfTurn = near ? halfTurnAcross(before, near->axis) : std::nullopt;
    if (!halfTurn)
      fail(R"("translate" takes the handle to the opposite side of the fixed vertices, so any axis across would do; )"
           R"(say which by "turn_near")");
    return *halfTurn;
  }

  void requireDirection(const Vector3& fromFixed, const std::string& when) const
  {
    if (fromFixed.stableNorm() <= kNoDirection * setting.surroundings.diagonal)
      fail("the centroid of the handle lies at that of the fixed vertices " + when +
           R"(, so it lies in no direction from them; say how it turns by "rotate")");
  }

  [[noreturn]] void fail(const std::string& reason) const { throw InputError(below(setting.where, ".turn"), reason); }
};

using PossibleError = std::optional<HandleError>;

// Fewer points never say how they turn.
constexpr std::size_t kLeastTargets = 3;
// The sine of the angle between x and y from which on y says the plane of both to half of its digits.
constexpr double kParallel = 1e-8;
// The axis of a rotation within rounding of none is noise.
constexpr double kNoRotation = 8 * std::numeric_limits<double>::epsilon();

/// The place of the first id that repeats one before it; their number where all differ.
std::size_t firstRepeated(const std::vector<Index>& ids)
{
  std::set<Index> known;
  std::size_t k = 0;
  while (k < ids.size() && known.insert(ids[k]).second) ++k;
  return k;
}

/// `key` gives something for each vertex, `count` in all.
PossibleError errorInList(const HandleConstraint& handle, const char* key, std::size_t count)
{
  const VertexIds* vertices = std::get_if<VertexIds>(&handle.select.what);
  if (vertices == nullptr)
    return HandleError{".select",
                       fmt::format("\"{}\" has one entry for each vertex of a list; select by \"vertices\"", key)};
  if (const std::size_t k = firstRepeated(vertices->ids); k < vertices->ids.size())
    return HandleError{
        fmt::format(".select.vertices[{}]", k),
        fmt::format("vertex {} is in this list already, and \"{}\" has one entry for each vertex; keep one",
                    vertices->ids[k], key)};
  if (count != vertices->ids.size())
    return HandleError{
        fmt::format(".{}", key),
        fmt::format("this list has {} {} for the {} vertices of \"select\"; give one for each, in their order", count,
                    count == 1 ? "entry" : "entries", vertices->ids.size())};
  return std::nullopt;
}

PossibleError errorInFrame(const Frame& frame, const std::string& key)
{
  if (frame.x.isZero(0)) return HandleError{key + ".x", "a direction cannot be zero in x, y and z"};
  if (frame.y.isZero(0)) return HandleError{key + ".y", "a direction cannot be zero in x, y and z"};
  const double sine = frame.x.stableNormalized().cross(frame.y.stableNormalized()).norm();
  if (sine <= kParallel)
    return HandleError{key + ".y",
                       R"(it is parallel to "x", so the frame could turn about it; give another direction)"};
  return std::nullopt;
}

PossibleError errorInScale(const HandleConstraint& handle)
{
  if (handle.scale == Vector3::Ones()) return std::nullopt;
  if (std::holds_alternative<VertexTargets>(handle.motion))
    return HandleError{".scale",
                       "its vertices have targets of their own, which no scale changes; leave one of both out"};
  for (const double factor : handle.scale)
    if (!(factor > 0)) return HandleError{".scale", fmt::format("factors must be above 0, this is {}", factor)};
  return std::nullopt;
}

struct MotionError {
  const HandleConstraint& handle;

  PossibleError operator()(const FrameMotion& motion) const
  {
    if (PossibleError error = errorInFrame(motion.from, ".frame.from")) return error;
    if (PossibleError error = errorInFrame(motion.to, ".frame.to")) return error;
    const Eigen::Matrix3d R = axesOf(motion.to) * axesOf(motion.from).transpose();
    if (motion.turns != 0 && rotationLog(R).norm() <= kNoRotation)
      return HandleError{".frame.turns",
                         R"(the frames have the same axes, so there is no axis to turn about; use "rotate")"};
    return std::nullopt;
  }
  PossibleError operator()(const VertexTargets& targets) const
  {
    if (PossibleError error = errorInList(handle, "targets", targets.places.size())) return error;
    if (targets.places.size() < kLeastTargets)
      return HandleError{".targets",
                         fmt::format(R"(at least {} vertices say how a handle turns, this one has {}; use constraints )"
                                     R"(of type "point" for single vertices)",
                                     kLeastTargets, targets.places.size())};
    return std::nullopt;
  }
  template <class Motion>
  PossibleError operator()(const Motion& /*motion*/) const
  {
    return std::nullopt;
  }
};

}  // namespace

Eigen::Matrix3d axesOf(const Frame& frame)
{
  Eigen::Matrix3d axes;
  axes.col(0) = frame.x.stableNormalized();
  const Vector3 y = frame.y.stableNormalized();
  axes.col(1) = (y - axes.col(0).dot(y) * axes.col(0)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

HandlePlacement placeHandle(const HandleConstraint& handle, const HandleSetting& setting)
{
  const Positions rest = scaledRest(handle, setting);
  const Placer placer{rest, handle.translate, setting};
  HandlePlacement result = std::visit(placer, handle.motion);
  placer.requireRange(result.places);
  if (handle.rotations.empty()) return result;
  for (Index k = 0; k < setting.rest.rows(); ++k)
    result.q.row(k) = rotationLog(handle.rotations[k].axis, handle.rotations[k].degrees).transpose();
  result.isDetermined = true;
  return result;
}

double shareMoved(const HandleConstraint& handle, const HandleSetting& setting)
{
  const auto& [fixedCenter, diagonal] = setting.surroundings;
  if (!fixedCenter) return 0;
  const double distance = (centroid(setting) - *fixedCenter).stableNorm();
  return distance <= kNoDirection * diagonal ? 0 : handle.translate.stableNorm() / distance;
}

Vector3 centroid(const Positions& points)
{
  assert(points.rows() > 0);
  return points.colwise().mean().transpose();
}

std::vector<Index> firstOfUnknowns(std::span<const Index> vertices, const std::vector<int>& unknownOf)
{
  std::vector<std::pair<int, Index>> places;  // of each unknown
  places.reserve(vertices.size());
  for (const Index vertex : vertices) places.emplace_back(unknownOf[vertex], static_cast<Index>(places.size()));
  std::ranges::sort(places);
  const auto isRepeated = [](const auto& a, const auto& b) { return a.first == b.first; };
  places.erase(std::unique(places.begin(), places.end(), isRepeated), places.end());
  std::vector<Index> result;
  result.reserve(places.size());
  for (const auto& [unknown, place] : places) result.push_back(place);
  std::ranges::sort(result);
  return result;
}

Positions HandleSetting::once(const Positions& ofVertices) const
{
  return counted.empty() ? ofVertices : Positions(ofVertices(counted, Eigen::all));
}

Vector3 centroid(const HandleSetting& setting)
{
  return centroid(setting.once(setting.rest));
}

std::optional<HandleError> validateHandle(const HandleConstraint& handle)
{
  if (PossibleError error = errorInScale(handle)) return error;
  if (PossibleError error = std::visit(MotionError{handle}, handle.motion)) return error;
  return handle.rotations.empty() ? std::nullopt : errorInList(handle, "rotations", handle.rotations.size());
}

}  // namespace holdfast
