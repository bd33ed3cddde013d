#pragma once
/// \file
/// A gizmo in a window of VTK alone.

#include <vtkCamera.h>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/gizmo/gizmo_layout.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>

#include "interaction/interaction_fixture.h"
#include "support/meshes.h"

namespace holdfast::test {

inline constexpr double kGizmoRadius = 90;  // pixels

/// A grid, seen from a corner so that no part of a gizmo along the axes of the world is faded.
struct GizmoFixture : InteractionFixture {
  GizmoFixture() : InteractionFixture(grid(4, 3), 400, 300)
  {
    vtkCamera& camera = *renderer().GetActiveCamera();
    camera.SetFocalPoint(1.5, 1, 0);
    camera.SetPosition(7.5, 8.5, 5.5);
    camera.SetViewUp(0, 0, 1);
    camera.SetParallelScale(3);
    renderer().ResetCameraClippingRange();
  }
};

/// Returns the pixel of a place that is given along the gizmo's axes, in radii of its outer ring.
[[nodiscard]] inline DisplayPoint placeOnGizmo(vtkHoldfastGizmoRepresentation& gizmo, const Vector3& place)
{
  const DisplayTransform view(*gizmo.GetRenderer());
  const GizmoFrame& frame = gizmo.GetFrame();
  const double scale = placementOf(view, frame, gizmo.GetPixelSize() * gizmo.GetPixelRatio()).scale;
  return *toDisplay(view, frame.center + scale * frame.axes * place);
}

/// The middle of the shaft of an arrow.
[[nodiscard]] inline DisplayPoint placeOnArrow(vtkHoldfastGizmoRepresentation& gizmo, int axis)
{
  return placeOnGizmo(gizmo, 0.5 * Vector3::Unit(axis));
}

}  // namespace holdfast::test
