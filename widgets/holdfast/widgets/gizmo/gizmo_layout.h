#pragma once
/// The parts of the gizmo: colours, layout on the display, how visible each is, and which one the cursor meets.

#include <holdfast/base/types.h>
#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

/// A part that can be grabbed. The square of an axis is across it.
enum class GizmoPart { None, Center, ArrowX, ArrowY, ArrowZ, SquareX, SquareY, SquareZ, RingX, RingY, RingZ, ViewRing };

inline constexpr int kGizmoPartCount = 12;  ///< `None` included

enum class GizmoPartKind { None, Center, Arrow, Square, Ring, ViewRing };

[[nodiscard]] constexpr GizmoPartKind kindOf(GizmoPart part)
{
  if (part == GizmoPart::None) return GizmoPartKind::None;
  if (part == GizmoPart::Center) return GizmoPartKind::Center;
  if (part <= GizmoPart::ArrowZ) return GizmoPartKind::Arrow;
  if (part <= GizmoPart::SquareZ) return GizmoPartKind::Square;
  return part <= GizmoPart::RingZ ? GizmoPartKind::Ring : GizmoPartKind::ViewRing;
}

/// Whether the part rotates; all others but `None` move.
[[nodiscard]] constexpr bool isRotation(GizmoPart part)
{
  return kindOf(part) == GizmoPartKind::Ring || kindOf(part) == GizmoPartKind::ViewRing;
}

/// 0, 1 and 2 for what belongs to x, y and z; -1 for what belongs to no axis.
[[nodiscard]] constexpr int axisIndexOf(GizmoPart part)
{
  const GizmoPartKind kind = kindOf(part);
  const bool hasAxis = kind == GizmoPartKind::Arrow || kind == GizmoPartKind::Square || kind == GizmoPartKind::Ring;
  return hasAxis ? (static_cast<int>(part) - static_cast<int>(GizmoPart::ArrowX)) % 3 : -1;
}

/// The place of a gizmo: the columns of `axes` are orthonormal and right-handed.
struct GizmoFrame {
  Vector3 center = Vector3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

inline constexpr Color kHighlightColor{0.98, 0.76, 0.18};

/// The colour of a part that is not highlighted.
[[nodiscard]] constexpr Color gizmoColor(GizmoPart part)
{
  constexpr Color kOfAxes[]{{0.84, 0.27, 0.24}, {0.33, 0.74, 0.52}, {0.15, 0.36, 0.74}};
  if (const int axis = axisIndexOf(part); axis >= 0) return kOfAxes[axis];
  return part == GizmoPart::ViewRing ? Color{0.50, 0.53, 0.58} : Color{0.93, 0.94, 0.96};
}

/// Lengths in radii of the outer ring.
namespace gizmo_layout {
inline constexpr double kBallRadius = 0.055;
inline constexpr double kShaftStart = 0.11;
inline constexpr double kHeadStart = 0.655;
inline constexpr double kArrowEnd = 0.82;
inline constexpr double kLabelAt = 0.9;
inline constexpr double kSquareStart = 0.20;
inline constexpr double kSquareEnd = 0.39;
inline constexpr double kRingRadius = 0.57;
inline constexpr double kTolerance = 0.06;
}  // namespace gizmo_layout

struct GizmoPlacement {
  GizmoFrame frame;
  double scale = 1;  ///< radius of the outer ring, model units
};

/// The outer ring has a radius of `pixels`; of no size (0) where it is not in front of the eye.
[[nodiscard]] GizmoPlacement placementOf(const DisplayTransform& view, const GizmoFrame& frame, double pixels);

/// From 0 (gone) to 1: arrows that point to the eye, and rings and squares that are seen edge-on, fade.
[[nodiscard]] double visibilityOf(GizmoPart part, const GizmoFrame& frame, const DisplayTransform& view);

/// From nearly 0 where a ring faces away from the eye to 1. `arm`: the unit direction from the center to the place.
[[nodiscard]] double ringVisibility(const Vector3& arm, const Vector3& sight);

/// Less visible parts cannot be hit.
inline constexpr double kLeastVisible = 0.5;

/// The part that the cursor meets: within 6 of 100 pixels of radius; of several the center first, then arrows, squares,
/// rings, the outer ring; of several of a kind the nearest.
[[nodiscard]] GizmoPart hitGizmo(const DisplayTransform& view, const GizmoPlacement& placement,
                                 const DisplayPoint& cursor);

}  // namespace holdfast
