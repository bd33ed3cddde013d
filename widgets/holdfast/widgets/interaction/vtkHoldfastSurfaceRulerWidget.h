#pragma once
/// Measures between two points of a surface.

#include <memory>
#include <optional>
#include <string>

#include <vtkDistanceWidget.h>

#include <holdfast/surface/surface_location.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceRulerRepresentation.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Measures between two points of a surface. A click on the surface places the first end, another one the second. Then
/// both ends can be dragged. A click beside them begins another ruler, with `NextRulerEvent` before it.
///
///     vtkNew<vtkHoldfastSurfaceRulerWidget> ruler;
///     ruler->SetInteractor(interactor);
///     ruler->SetSurface(surface);
///     ruler->SetUnits("mm");
///     ruler->AddObserver(vtkCommand::EndInteractionEvent, &tool, &Tool::measured);  // reads `GetDistance`
///     ruler->On();
///
/// These are the bindings, each with its widget event:
///
///     MouseMoveEvent           Move: moves the second end, or the end that is dragged
///     LeftButtonPressEvent     AddPoint: grabs an end, or begins a click
///     LeftButtonReleaseEvent   EndSelect: lets the end go, or places one
///     KeyPressEvent Escape     Reset: removes a half-drawn ruler, or takes a drag back
///
/// These are the events that it invokes:
///
///     StartInteractionEvent     the first end is placed, or an end is grabbed
///     PlacePointEvent           a click has placed an end; call data: `int*`, 0 or 1
///     InteractionEvent          the second end goes with the cursor, or an end is dragged
///     EndInteractionEvent       the second end is placed, or an end is let go
///     NextRulerEvent            a click is about to begin another ruler; the present one can still be read
///     CancelInteractionEvent    the half-drawn ruler is gone, or the end is back where it was
///
/// Ends are on vertices, on edges or in faces, and move with the surface. A click is as `Click` describes. A drag of an
/// end aborts its events.
class vtkHoldfastSurfaceRulerWidget
    : public holdfast::WidgetOf<vtkHoldfastSurfaceRulerRepresentation, vtkDistanceWidget> {
 public:
  static vtkHoldfastSurfaceRulerWidget* New();
  vtkTypeMacro(vtkHoldfastSurfaceRulerWidget, vtkDistanceWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] vtkHoldfastSurfaceRulerRepresentation* GetRulerRepresentation() { return &this->Drawn(); }
  /// Enables or disables the widget. Disabling cancels a drag or a half-drawn ruler, and keeps a complete one.
  void SetEnabled(int enabling) override;

  /// Sets the surface; with null, the default, nothing is measured. The ends move with it. The ruler is removed where
  /// the surface is that of another mesh.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface);
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }
  void SetUnits(const std::string& units) { this->Drawn().SetUnits(units); }
  [[nodiscard]] vtkHoldfastSurfacePointPlacer* GetPlacer() { return this->Drawn().GetPlacer(); }

  /// Makes a ruler from `a` to `b`. Set a surface first: without one VTK reports an error, and nothing changes. The
  /// call takes back what is under way, as `Cancel` does, and invokes no other events. It throws `InputError`, and
  /// changes nothing more, where the mesh does not have a location. O(T log T).
  void SetLocations(const holdfast::SurfaceLocation& a, const holdfast::SurfaceLocation& b);
  /// Returns the location of end 0 or 1; null while it is not placed. It is valid until the end is placed elsewhere.
  [[nodiscard]] const holdfast::SurfaceLocation* GetLocation(int end);
  /// Removes the ruler, without events. The next click places a first end.
  void Clear();

  /// Return the distance now and at rest, in model units; 0 before both ends are placed.
  [[nodiscard]] double GetDistance() { return this->Drawn().GetDistance(); }
  [[nodiscard]] double GetRestDistance() { return this->Drawn().GetRestDistance(); }

  /// Tells whether a gesture is under way. Either the first end is placed and the second goes with the cursor, or an
  /// end is dragged.
  [[nodiscard]] bool IsUnderWay() const { return this->WidgetState == vtkDistanceWidget::Define || this->GrabbedAt; }
  /// Takes back what is under way, as Escape does. It returns false where nothing is under way.
  bool Cancel();

 protected:
  vtkHoldfastSurfaceRulerWidget();
  ~vtkHoldfastSurfaceRulerWidget() override = default;

 private:
  void Press();
  void Move();
  void Release();

  void Hover();
  void StopDrag();
  void PrepareHandles();

  std::optional<holdfast::SurfacePlacement> GrabbedAt;  // where the end that is dragged was before
};
