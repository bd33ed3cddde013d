#pragma once
/// A drag with the mouse adds one rigid motion to the motion of a handle. These functions say what handle results.

#include <holdfast/constraints/handle_motion.h>

namespace holdfast {

/// An increment is the rigid motion p -> R (p - pivot) + pivot + translation. R is the turn by `degrees` (any number of
/// turns) about `axis` (any length). There is no turn where the axis is zero.
struct RigidIncrement {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0;
  Vector3 pivot = Vector3::Zero();  ///< model units, as are places on the surface when the drag begins
  Vector3 translation = Vector3::Zero();
};

/// Returns `turn` and then `next`, as one turn. Where both turn about one line, their degrees are added. Else the
/// rotations are composed. The log is then that which follows from that of `turn` while `next` grows from nothing. So
/// nothing jumps during a drag. O(degrees of `next`), bounded.
[[nodiscard]] AxisAngle composed(const AxisAngle& turn, const AxisAngle& next);

/// Returns the handle that goes where `handle` goes, and then by `increment`. `handle` has no mistake. A mere
/// translation changes `HandleConstraint::translate` alone. No increment gives `handle` back, bit for bit. With a
/// rotation the motion changes:
/// - No motion, an `AxisRotation` and a `RotationAboutFixed` become an `AxisRotation`. It has their center. Where there
///   was no motion, its center is the pivot, or the centroid that the handle is scaled about.
/// - The `to` of a `FrameMotion` moves. Where its frames are too nearly alike for whole turns, it becomes an
///   `AxisRotation`. Frames along which factors differ stay, and lose those turns.
/// - Each place of `VertexTargets` moves. Beyond half a turn `rotations` say how the handle turns.
/// Entries of `HandleConstraint::rotations` are rotated as well. Throws what `placeHandle` throws, and costs as much.
[[nodiscard]] HandleConstraint composed(const HandleConstraint& handle, const RigidIncrement& increment,
                                        const HandleSetting& setting);

/// Returns how many whole turns about the axis of the frames make the log of their rotation `q`. Returns none where the
/// frames say no axis.
[[nodiscard]] std::optional<Index> wholeTurns(const FrameMotion& frames, const Vector3& q);

/// Returns how the motion of `handle` turns it. Throws what `placeHandle` throws, and costs as much.
[[nodiscard]] AxisAngle rotationOfMotion(HandleConstraint handle, const HandleSetting& setting);

/// Returns `handle` as it is one step of a drag after it turned by `last`. Where it turns about what is fixed, it turns
/// by what is nearest to `last`. From half a turn on it says so (`RotationAboutFixed::near`). Throws what `placeHandle`
/// throws, and costs as much.
[[nodiscard]] HandleConstraint followed(HandleConstraint handle, const AxisAngle& last, const HandleSetting& setting);

}  // namespace holdfast
