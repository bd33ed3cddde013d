#pragma once
/// The parts of the gizmo: their colours, their layout on the display, how visible each is, and which one the cursor
/// meets.

#include <holdfast/numbers/types.h>
#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

/// The parts that can be grabbed, and `None`. The square of an axis lies across it.
enum class GizmoPart { None, Center, ArrowX, ArrowY, ArrowZ, SquareX, SquareY, SquareZ, RingX, RingY, RingZ, ViewRing };

inline constexpr int kGizmoPartCount = 12;  ///< how many parts there are, with `None`

enum class GizmoPartKind { None, Center, Arrow, Square, Ring, ViewRing };

[[nodiscard]] constexpr GizmoPartKind kindOf(GizmoPart part)
{
  if (part == GizmoPart::None) return GizmoPartKind::None;
  if (part == GizmoPart::Center) return GizmoPartKind::Center;
  if (part <= GizmoPart::ArrowZ) return GizmoPartKind::Arrow;
  if (part <= GizmoPart::SquareZ) return GizmoPartKind::Square;
  return part <= GizmoPart::RingZ ? GizmoPartKind::Ring : GizmoPartKind::ViewRing;
}

/// Tells whether the part rotates. All other parts but `None` move.
[[nodiscard]] constexpr bool isRotation(GizmoPart part)
{
  return kindOf(part) == GizmoPartKind::Ring || kindOf(part) == GizmoPartKind::ViewRing;
}

/// Returns 0, 1 and 2 for a part that belongs to x, y and z, and -1 for one that belongs to no axis.
[[nodiscard]] constexpr int axisIndexOf(GizmoPart part)
{
  const GizmoPartKind kind = kindOf(part);
  const bool hasAxis = kind == GizmoPartKind::Arrow || kind == GizmoPartKind::Square || kind == GizmoPartKind::Ring;
  return hasAxis ? (static_cast<int>(part) - static_cast<int>(GizmoPart::ArrowX)) % 3 : -1;
}

/// The place of a gizmo. The columns of `axes` are orthonormal and right-handed.
struct GizmoFrame {
  Vector3 center = Vector3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

inline constexpr Color kHighlightColor{0.98, 0.76, 0.18};

/// Returns the colour of a part that is not highlighted.
[[nodiscard]] constexpr Color gizmoColor(GizmoPart part)
{
  constexpr Color kOfAxes[]{{0.84, 0.27, 0.24}, {0.33, 0.74, 0.52}, {0.15, 0.36, 0.74}};
  if (const int axis = axisIndexOf(part); axis >= 0) return kOfAxes[axis];
  return part == GizmoPart::ViewRing ? Color{0.50, 0.53, 0.58} : Color{0.93, 0.94, 0.96};
}

/// These lengths are in radii of the outer ring.
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

/// Returns the placement by which the outer ring has a radius of `pixels`. Its scale is 0 where the gizmo is not in
/// front of the eye.
[[nodiscard]] GizmoPlacement placementOf(const DisplayTransform& view, const GizmoFrame& frame, double pixels);

/// Returns how visible a part is, from 0 (gone) to 1. Arrows that point to the eye fade, as do rings and squares that
/// are seen edge-on.
[[nodiscard]] double visibilityOf(GizmoPart part, const GizmoFrame& frame, const DisplayTransform& view);

/// Returns how visible a ring is at one place: 1 where it faces the eye, down to 0.16 where it faces away. `arm` is the
/// unit direction from the centre to the place. `sight` is the unit direction in which the gizmo is seen.
[[nodiscard]] double ringVisibility(const Vector3& arm, const Vector3& sight);

/// The least visibility of a part that can be hit.
inline constexpr double kLeastVisible = 0.5;

/// Returns the part that the cursor meets: one that is within 6 of 100 pixels of radius. Of several the centre comes
/// first, then arrows, squares, rings, and the outer ring. Of several of one kind it is the nearest.
[[nodiscard]] GizmoPart hitGizmo(const DisplayTransform& view, const GizmoPlacement& placement,
                                 const DisplayPoint& cursor);

}  // namespace holdfast
