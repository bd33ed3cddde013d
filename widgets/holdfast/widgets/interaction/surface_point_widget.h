#pragma once
/// Lets the user choose a point of a surface: on a vertex, on an edge or in a face.

#include <memory>
#include <optional>

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_point_placer.h>
#include <holdfast/widgets/marks/point_preview.h>
#include <holdfast/widgets/mesh/actors.h>

namespace holdfast {

/// Draws a ring around a mark, and the outline of the edge or the face. The mark differs for vertex, edge and face.
/// Hidden parts of the outline are faint. The surface around the point does not cut the ring, but a surface before it
/// hides it.
class SurfacePointRepresentation : public DrawnByProps<vtkWidgetRepresentation> {
 public:
  static SurfacePointRepresentation* New();
  vtkTypeMacro(SurfacePointRepresentation, vtkWidgetRepresentation)

  /// Sets the surface. A point that is shown moves with it, and is removed where the surface is that of another mesh.
  /// With null, the default, no point is shown.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Shows the location of `pick`. It shows nothing for none, the default, and while there is no surface.
  void SetPreview(std::optional<SurfacePick> pick);
  [[nodiscard]] const std::optional<SurfacePick>& GetPreview() const { return this->Preview; }

  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  void BuildRepresentation() override;

 protected:
  SurfacePointRepresentation();
  ~SurfacePointRepresentation() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
  std::optional<SurfacePick> Preview;
  double PixelRatio = 1;
  PointPreview Point;
  vtkNew<vtkPolyData> Outline;
  vtkNew<BehindActor> LineBehind;
  vtkNew<BlendedActor> LineHalo;
  vtkNew<BlendedActor> Line;
};

/// Shows the point that a click would take, and reports it when it is clicked. A click is as `Click` describes. The
/// second press of a double click begins no click.
///
///     vtkNew<SurfacePointWidget> point;
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
class SurfacePointWidget : public WidgetOf<SurfacePointRepresentation> {
 public:
  /// Widget events beside those of VTK. Each chooses what points may lie on.
  enum WidgetEvents : unsigned long {
    ChooseVertices = vtkWidgetEvent::HoverLeave + 18'500,
    ChooseEdges,
    ChooseFaces,
    ChooseNearest
  };

  static SurfacePointWidget* New();
  vtkTypeMacro(SurfacePointWidget, vtkAbstractWidget)

  [[nodiscard]] SurfacePointRepresentation* GetSurfacePointRepresentation() { return &this->Drawn(); }

  /// Sets the surface; with null, the default, there are no points. It may change at any time, see
  /// `SurfacePointRepresentation::SetSurface`.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  /// Chooses what points may lie on, as a key does, but without `WidgetValueChangedEvent`.
  void SetKind(PickKind kind);
  [[nodiscard]] PickKind GetKind() const { return this->Placer->GetKind(); }
  /// Sets the ratio of placer and representation.
  void SetPixelRatio(double ratio);
  [[nodiscard]] double GetPixelRatio() const { return this->Placer->GetPixelRatio(); }
  /// Returns the placer, which finds the point at the cursor. Set its `SnapPixels` here, all else by the functions
  /// above.
  [[nodiscard]] SurfacePointPlacer* GetPlacer() const { return this->Placer; }

  /// Shows a point as the mouse does, or none, without an event.
  void SetPreview(std::optional<SurfacePick> pick);
  void HidePreview() { this->SetPreview(std::nullopt); }
  [[nodiscard]] const std::optional<SurfacePick>& GetPreview() { return this->Drawn().GetPreview(); }

  /// Tells whether a key is bound. A window asks this before its shortcuts.
  [[nodiscard]] bool WantsKey(char key) const;

 protected:
  SurfacePointWidget();
  ~SurfacePointWidget() override = default;

  void Inform(SurfacePointRepresentation& representation) override;
  void Stop() override { this->Leave(); }

 private:
  void Hover();
  void Leave();
  void Release();
  template <PickKind Kind>
  bool Choose();

  [[nodiscard]] std::optional<SurfacePick> PickAtCursor() const
  {
    return this->Placer->Pick(*this->CurrentRenderer, this->Cursor().data());
  }
  void Show(std::optional<SurfacePick> pick);

  vtkNew<SurfacePointPlacer> Placer;
  bool IsHovering = false;  // the cursor is in the renderer, and nothing moves the camera
};

}  // namespace holdfast
