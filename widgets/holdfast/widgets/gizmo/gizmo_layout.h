#pragma once
/// \file
/// How the gizmo is laid out on the display, how visible each part is, and which one the cursor meets.

#include <holdfast/widgets/camera/view_geometry.h>
#include <holdfast/widgets/gizmo/gizmo_part.h>

namespace holdfast {

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

/// Where the gizmo stands, and how large it is for one view.
struct GizmoPlacement {
  GizmoFrame frame;
  double scale = 1;  ///< radius of the outer ring, model units
};

/// As large as it takes for the outer ring to have a radius of `pixels`. Of no size (0) where it is not in front of
/// the eye.
[[nodiscard]] GizmoPlacement placementOf(const ViewGeometry& view, const GizmoFrame& frame, double pixels);

/// From 0 (gone) to 1: arrows fade as they turn towards the eye, rings and squares as they turn edge-on.
[[nodiscard]] double visibilityOf(GizmoPart part, const GizmoFrame& frame, const ViewGeometry& view);

/// From nearly 0 on the half of a ring that is turned away from the eye to 1. `arm`: from the center to a place of the
/// ring, of unit length.
[[nodiscard]] double ringVisibility(const Vector3& arm, const Vector3& sight);

/// What is less visible cannot be hit.
inline constexpr double kLeastVisible = 0.5;

/// The part that the cursor meets: within 6 of 100 pixels of radius; of several the center first, then arrows, squares,
/// rings, the outer ring; of several of a kind the nearest.
[[nodiscard]] GizmoPart hitGizmo(const ViewGeometry& view, const GizmoPlacement& placement, const DisplayPoint& cursor);

}  // namespace holdfast
