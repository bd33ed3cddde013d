#pragma once
/// Lets the user choose a point of a surface: on a vertex, on an edge or in a face.

#include <memory>

#include <vtkNew.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointRepresentation.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Shows the point that a click would take, and reports it when it is clicked. A click is as `Click` describes. The
/// second press of a double click begins no click.
///
///     vtkNew<vtkHoldfastSurfacePointWidget> point;
///     point->SetInteractor(interactor);
///     point->SetSurface(surface);
///     point->AddObserver(vtkCommand::PlacePointEvent, &tool, &Tool::hold);  // call data: `SurfacePick*`
///     point->On();
///
/// These are the bindings, each with its widget event:
///
///     MouseMoveEvent                  Move: shows the point under the cursor
///     LeaveEvent, MouseWheel...Event  HoverLeave: hides it
///     LeftButtonPressEvent            Select: begins a click
///     LeftButtonReleaseEvent          AddPoint: ends the click, and reports the point
///     CharEvent v, e, f, a            ChooseVertices, ChooseEdges, ChooseFaces, ChooseNearest
///
/// These are the events that it invokes:
///
///     InteractionEvent          the cursor has moved over the surface; call data: `SurfacePick*`. Once more, with
///                               null, when the point goes
///     PlacePointEvent           a click on a point; call data: `SurfacePick*`
///     WidgetValueChangedEvent   a key has chosen what points may lie on; call data: `PickKind*`
///
/// The keys are those of CharEvent, by which VTK's own styles would quit or fly. The widget aborts those that it uses.
class vtkHoldfastSurfacePointWidget : public holdfast::WidgetOf<vtkHoldfastSurfacePointRepresentation> {
 public:
  /// Widget events beside those of VTK. Each chooses what points may lie on.
  enum WidgetEvents : unsigned long {
    ChooseVertices = vtkWidgetEvent::HoverLeave + 18'500,
    ChooseEdges,
    ChooseFaces,
    ChooseNearest
  };

  static vtkHoldfastSurfacePointWidget* New();
  vtkTypeMacro(vtkHoldfastSurfacePointWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] vtkHoldfastSurfacePointRepresentation* GetSurfacePointRepresentation() { return &this->Drawn(); }

  /// Sets the surface; with null, the default, there are no points. It may change at any time, see
  /// `vtkHoldfastSurfacePointRepresentation::SetSurface`.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface);
  /// Chooses what points may lie on, as a key does, but without `WidgetValueChangedEvent`.
  void SetKind(holdfast::PickKind kind);
  [[nodiscard]] holdfast::PickKind GetKind() const { return this->Placer->GetKind(); }
  /// Sets the ratio of placer and representation.
  void SetPixelRatio(double ratio);
  [[nodiscard]] double GetPixelRatio() const { return this->Placer->GetPixelRatio(); }
  /// Returns the placer, which finds the point at the cursor. Set its `SnapPixels` here, all else by the functions
  /// above.
  [[nodiscard]] vtkHoldfastSurfacePointPlacer* GetPlacer() const { return this->Placer; }

  /// Shows a point as the mouse does, or none for null, without an event.
  void SetPreview(const holdfast::SurfacePick* pick);
  void HidePreview() { this->SetPreview(nullptr); }
  /// Returns the point that is shown, or null, as the representation does.
  [[nodiscard]] const holdfast::SurfacePick* GetPreview() { return this->Drawn().GetPreview(); }

  /// Tells whether a key is bound. A window asks this before its shortcuts.
  [[nodiscard]] bool WantsKey(char key) const;

 protected:
  vtkHoldfastSurfacePointWidget();
  ~vtkHoldfastSurfacePointWidget() override = default;

  void Inform(vtkHoldfastSurfacePointRepresentation& representation) override;
  void Stop() override { this->Leave(); }

 private:
  void Hover();
  void Leave();
  void Release();
  template <holdfast::PickKind Kind>
  bool Choose();

  [[nodiscard]] bool PickAtCursor(holdfast::SurfacePick& pick) const
  {
    return this->Placer->Pick(*this->CurrentRenderer, this->Cursor().data(), pick);
  }
  void ShowPickAtCursor();
  void Show(holdfast::SurfacePick* pick);

  vtkNew<vtkHoldfastSurfacePointPlacer> Placer;
  bool IsHovering = false;  // the cursor is in the renderer, and nothing moves the camera
};
