#include "holdfast/constraints/handle_drag.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

using std::numbers::pi;

// The sine of the angle between two axes that are one, computed in two ways.
constexpr double kSameAxis = 1e-12;

// Logs are followed in steps of this size, counted from the beginning of the turn: so a drag that goes on finds the
// same steps behind it. The number of steps is bounded for turns that no drag makes.
constexpr double kStepDegrees = 1;
constexpr double kMostSteps = 20000;

// Closer to whole turns than a third of a step, the axis does not show where the log came from.
constexpr double kNoStep = kStepDegrees / 360 * pi / 3;

// A log shorter than this has lost three digits of its axis, and whole turns about it would show that.
constexpr double kLeastAxis = 1e-3;

// Doubles count up to here one by one.
constexpr double kMostTurns = 9e15;

// Just short of half a turn, from where on rounding would choose between its two logs.
constexpr double kHalfTurn = pi / 2 * (1 - 1e-9);

bool isNone(const AxisAngle& turn)
{
  return turn.degrees == 0 || turn.axis.isZero(0);
}

AxisAngle turnOf(const Vector3& q)
{
  return q.isZero(0) ? AxisAngle{} : AxisAngle{q.stableNormalized(), angleDegrees(q)};
}

Vector3 logOf(const AxisAngle& turn)
{
  return rotationLog(turn.axis, turn.degrees);
}

/// The log of `next` after `start`, followed from `start`.
Vector3 followedLog(const AxisAngle& start, const AxisAngle& next)
{
  const Vector3 first = logOf(start);
  const Eigen::Quaterniond rotation = rotationExp(first);
  const double steps = std::min(std::floor(std::abs(next.degrees) / kStepDegrees), kMostSteps);
  const auto after = [&](double degrees) { return rotationExp(rotationLog(next.axis, degrees)) * rotation; };
  Vector3 q = first;
  for (double k = 1; k <= steps; ++k) {
    const Eigen::Quaterniond step = after(std::copysign(k * kStepDegrees, next.degrees));
    if (step.vec().norm() > kNoStep) q = rotationLogNear(step, q);
  }
  return rotationLogNear(after(next.degrees), q);
}

/// What a turn about the pivot adds to the place of `from`: exactly nothing at the pivot.
Vector3 swing(const RigidIncrement& increment, const Vector3& from)
{
  const Vector3 arm = from - increment.pivot;
  return rotationMatrix(increment.axis, increment.degrees) * arm - arm;
}

/// One overload for each motion: turns the handle, whose `translate` is still the one before.
struct Rotator {
  HandleConstraint& handle;
  const RigidIncrement& increment;
  const HandleSetting& setting;
  const AxisAngle& before;

  void operator()(std::monostate) const
  {
    if (handle.scale != Vector3::Ones()) return rotateAbout(std::nullopt);
    handle.motion = AxisRotation{increment.axis, increment.degrees, increment.pivot - handle.translate};
  }

  void operator()(const AxisRotation& turn) const { rotateAbout(turn.center); }

  void operator()(const RotationAboutFixed& /*turn*/) const { rotateAbout(std::nullopt); }

  void operator()(const FrameMotion& motion) const
  {
    const Vector3 from = motion.from.origin.value_or(centroid(setting));
    const Vector3 origin = motion.to.origin.value_or(from);
    const Eigen::Matrix3d R = rotationMatrix(increment.axis, increment.degrees);
    FrameMotion moved = motion;
    moved.to = {origin + swing(increment, origin + handle.translate), R * motion.to.x.stableNormalized(),
                R * motion.to.y.stableNormalized()};
    const AxisAngle turn = after();
    const std::optional<Index> turns = wholeTurns(moved, logOf(turn));
    if (turns || !isUniform(handle.scale)) {
      moved.turns = turns.value_or(0);
      handle.motion = std::move(moved);
    } else {
      handle.motion = AxisRotation{turn.axis, turn.degrees, from};
      handle.translate += *moved.to.origin - from;
    }
  }

  void operator()(const VertexTargets& targets) const
  {
    VertexTargets moved = targets;
    for (Vector3& place : moved.places) place += swing(increment, place + handle.translate);
    handle.motion = std::move(moved);
    const AxisAngle turn = after();
    if (handle.rotations.empty() && logOf(turn).norm() > kHalfTurn)
      handle.rotations.assign(targets.places.size(), turn);
  }

 private:
  [[nodiscard]] AxisAngle after() const { return composed(before, {increment.axis, increment.degrees}); }

  void rotateAbout(const std::optional<Vector3>& center) const
  {
    const AxisAngle turn = after();
    handle.translate += swing(increment, center.value_or(centroid(setting)) + handle.translate);
    handle.motion = AxisRotation{turn.axis, turn.degrees, center};
  }
};

}  // namespace

std::optional<Index> wholeTurns(const FrameMotion& frames, const Vector3& q)
{
  const Vector3 shortest = rotationLog(Eigen::Matrix3d(axesOf(frames.to) * axesOf(frames.from).transpose()));
  const double turns = (q - shortest).dot(shortest.normalized()) / pi;
  const bool hasAxis = shortest.norm() >= kLeastAxis && std::abs(turns) <= kMostTurns;
  return hasAxis || q.norm() <= kHalfTurn ? std::optional(static_cast<Index>(std::llround(turns))) : std::nullopt;
}

AxisAngle rotationOfMotion(HandleConstraint handle, const HandleSetting& setting)
{
  if (const AxisRotation* turn = std::get_if<AxisRotation>(&handle.motion)) return {turn->axis, turn->degrees};
  handle.rotations.clear();
  return turnOf(placeHandle(handle, setting).q.row(0).transpose());
}

HandleConstraint followed(HandleConstraint handle, const AxisAngle& last, const HandleSetting& setting)
{
  auto* const about = std::get_if<RotationAboutFixed>(&handle.motion);
  if (about == nullptr) return handle;
  about->near = last;
  const AxisAngle turn = rotationOfMotion(handle, setting);
  about->near = logOf(turn).norm() > kHalfTurn ? std::optional(turn) : std::nullopt;
  return handle;
}

AxisAngle composed(const AxisAngle& turn, const AxisAngle& next)
{
  if (isNone(next)) return turn;
  if (isNone(turn)) return next;
  const Vector3 axis = turn.axis.stableNormalized();
  const Vector3 other = next.axis.stableNormalized();
  if (axis.cross(other).norm() <= kSameAxis)
    return {turn.axis, turn.degrees + std::copysign(1.0, axis.dot(other)) * next.degrees};
  return turnOf(followedLog(turn, next));
}

HandleConstraint composed(const HandleConstraint& handle, const RigidIncrement& increment, const HandleSetting& setting)
{
  const AxisAngle next{increment.axis, increment.degrees};
  HandleConstraint result = handle;
  if (!isNone(next)) {
    const AxisAngle before = rotationOfMotion(handle, setting);
    for (AxisAngle& turn : result.rotations) turn = composed(turn, next);
    std::visit(Rotator{result, increment, setting, before}, handle.motion);
  }
  if (!increment.translation.isZero(0)) result.translate += increment.translation;
  return result;
}

}  // namespace holdfast
