#pragma once
/// Draws the plane that cuts a surface open, and finds the part of it under the cursor.

#include <memory>
#include <utility>

#include <vtkImplicitPlaneRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Differs from VTK's representation in where the plane takes the mouse: only beside the surface, so that the user can
/// pick behind a cut. Its arrow and the ball in its middle take the mouse everywhere.
///
///     vtkNew<vtkHoldfastSectionPlaneRepresentation> plane;
///     plane->PlaceWidget(bounds);  // double[6]
///     plane->SetSurface(surface);
///     vtkNew<vtkImplicitPlaneWidget2> widget;
///     widget->SetInteractor(interactor);
///     widget->SetRepresentation(plane);
///     widget->On();
///
/// Bindings and events are those of `vtkImplicitPlaneWidget2`. The left button moves or rotates the part under the
/// cursor, the middle one moves the plane, the right one scales. Arrow keys move it along its normal.
/// `InteractionEvent` comes for each of these motions.
class vtkHoldfastSectionPlaneRepresentation : public vtkImplicitPlaneRepresentation {
 public:
  static vtkHoldfastSectionPlaneRepresentation* New();
  vtkTypeMacro(vtkHoldfastSectionPlaneRepresentation, vtkImplicitPlaneRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the part of the surface that the cut keeps. With null, the default, the plane takes the mouse everywhere.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface) { this->Surface = std::move(surface); }

  int ComputeInteractionState(int x, int y, int modify = 0) override;

 protected:
  vtkHoldfastSectionPlaneRepresentation() = default;
  ~vtkHoldfastSectionPlaneRepresentation() override = default;

 private:
  std::shared_ptr<const holdfast::VisibleSurface> Surface;
};
