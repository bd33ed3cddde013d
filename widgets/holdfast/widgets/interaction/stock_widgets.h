#pragma once
/// VTK's own widgets with small changes. One shows the camera's orientation by axes in a corner of the window, and
/// changes it. The other is the plane that cuts a surface open.

#include <memory>
#include <utility>

#include <vtkCameraOrientationRepresentation.h>
#include <vtkCameraOrientationWidget.h>
#include <vtkImplicitPlaneRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// Differs from VTK's representation in two ways. A click on a ball looks from behind only where that ball faces the
/// viewer. (VTK does so at every second click on the same ball.) Balls and letters are moved, not made for each
/// picture: making them would wait for the drawing.
class OrientationRepresentation : public vtkCameraOrientationRepresentation {
 public:
  static OrientationRepresentation* New();
  vtkTypeMacro(OrientationRepresentation, vtkCameraOrientationRepresentation)

  void EndWidgetInteraction(double place[2]) override;

 protected:
  OrientationRepresentation();
  ~OrientationRepresentation() override = default;

  void CreateDefaultGeometry() override {}
  void PositionHandles() override;
  void HighlightHandle() override;

 private:
  std::pair<int, int> LetteredFor{-2, -2};  // axis and direction of the ball that was picked
};

/// Shows the camera's orientation by axes in a corner of the window. A click on a ball of an axis looks along that
/// axis.
///
///     vtkNew<OrientationWidget> axes;
///     axes->SetParentRenderer(renderer);  // it is in a window with an interactor
///     axes->On();
///
/// The bindings are those of `vtkCameraOrientationWidget`, each with its widget event. They are for the cursor on the
/// axes:
///
///     MouseMoveEvent            Move: highlights the ball under the cursor, or rotates the camera
///     LeftButtonPressEvent      Select: takes the ball under the cursor
///     LeftButtonReleaseEvent    EndSelect: looks along the axis of that ball, or ends the rotation
///
/// These are the events that it invokes, without call data:
///
///     StartInteractionEvent     the button went down on the axes
///     InteractionEvent          a drag has rotated the camera
///     EndInteractionEvent       the button came up
class OrientationWidget : public WidgetOf<OrientationRepresentation, vtkCameraOrientationWidget> {
 public:
  static OrientationWidget* New();
  vtkTypeMacro(OrientationWidget, vtkCameraOrientationWidget)

  [[nodiscard]] OrientationRepresentation* GetOrientationRepresentation() { return &this->Drawn(); }

  void SetPixelRatio(double ratio);

 protected:
  OrientationWidget() = default;
  ~OrientationWidget() override = default;
};

/// Differs from VTK's representation in where the plane takes the mouse: only beside the surface, so that the user can
/// pick behind a cut. Its arrow and the ball in its middle take the mouse everywhere.
///
///     vtkNew<SectionPlaneRepresentation> plane;
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
class SectionPlaneRepresentation : public vtkImplicitPlaneRepresentation {
 public:
  static SectionPlaneRepresentation* New();
  vtkTypeMacro(SectionPlaneRepresentation, vtkImplicitPlaneRepresentation)

  /// Sets the part of the surface that the cut keeps. With null, the default, the plane takes the mouse everywhere.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Surface = std::move(surface); }

  int ComputeInteractionState(int x, int y, int modify = 0) override;

 protected:
  SectionPlaneRepresentation() = default;
  ~SectionPlaneRepresentation() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
};

}  // namespace holdfast
