#pragma once
/// What a drag with the mouse makes of a handle: its motion, and one rigid motion more.

#include <holdfast/constraints/handle_motion.h>

namespace holdfast {

/// The rigid motion p -> R (p - pivot) + pivot + translation, with R the turn by `degrees` (any number of turns) about
/// `axis` (any length; no turn where it is zero).
struct RigidIncrement {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0;
  Vector3 pivot = Vector3::Zero();  ///< model units, as are places on the surface when the drag begins
  Vector3 translation = Vector3::Zero();
};

/// `turn` and then `next`, as one turn. About one line degrees are added; else the rotations are composed, and the log
/// is that which follows from that of `turn` while `next` grows from nothing: nothing jumps during a drag. O(degrees of
/// `next`), bounded.
[[nodiscard]] AxisAngle composed(const AxisAngle& turn, const AxisAngle& next);

/// The handle that goes where `handle` goes, which has no mistake, and then by `increment`. A mere translation changes
/// `HandleConstraint::translate` alone; no increment gives `handle` back, bit for bit. With a rotation
/// - no motion, an `AxisRotation` and a `RotationAboutFixed` become an `AxisRotation`, with their center, or the pivot;
/// - the `to` of a `FrameMotion` moves; where its frames are too nearly alike for whole turns, it becomes an
///   `AxisRotation`;
/// - each place of `VertexTargets` moves; beyond half a turn `rotations` say how.
/// Entries of `HandleConstraint::rotations` are rotated as well. Throws and costs as `placeHandle`.
[[nodiscard]] HandleConstraint composed(const HandleConstraint& handle, const RigidIncrement& increment,
                                        const HandleSetting& setting);

/// The whole turns about the axis of the frames that make the log of their rotation `q`; none where they say no axis.
[[nodiscard]] std::optional<Index> wholeTurns(const FrameMotion& frames, const Vector3& q);

/// How the motion of `handle` turns it. Throws and costs as `placeHandle`.
[[nodiscard]] AxisAngle rotationOfMotion(HandleConstraint handle, const HandleSetting& setting);

/// `handle`, one step of a drag after it turned by `last`: where it turns about what is fixed, it turns by what is
/// nearest to that, and says so from half a turn on (`RotationAboutFixed::near`). Throws and costs as `placeHandle`.
[[nodiscard]] HandleConstraint followed(HandleConstraint handle, const AxisAngle& last, const HandleSetting& setting);

}  // namespace holdfast
