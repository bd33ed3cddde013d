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

/// A ring around a mark that differs for vertex, edge and face, and the outline of the edge or the face; hidden parts
/// of the outline are faint. The surface around the point does not cut the ring, a surface before it hides it.
class SurfacePointRepresentation : public DrawnByProps<vtkWidgetRepresentation> {
 public:
  static SurfacePointRepresentation* New();
  vtkTypeMacro(SurfacePointRepresentation, vtkWidgetRepresentation)

  /// A point that is shown moves with it, and is removed where it is another mesh's. Null, the default: none is shown.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Shows the location of `pick`; none, the default, and without a surface: nothing.
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

/// Shows the point that a click would take. Clicks are as in `Click`; the second press of a double click begins none.
///
/// Keys are those of CharEvent, by which VTK's own styles would quit or fly: those that are used are aborted.
class SurfacePointWidget : public WidgetOf<SurfacePointRepresentation> {
 public:
  /// Widget events beside those of VTK.
  enum WidgetEvents : unsigned long {
    ChooseVertices = vtkWidgetEvent::HoverLeave + 18'500,
    ChooseEdges,
    ChooseFaces,
    ChooseNearest
  };

  static SurfacePointWidget* New();
  vtkTypeMacro(SurfacePointWidget, vtkAbstractWidget)

  [[nodiscard]] SurfacePointRepresentation* GetSurfacePointRepresentation() { return &this->Drawn(); }

  /// Null (the default): no points. May change at any time, see `SurfacePointRepresentation::SetSurface`.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  /// As a key does, without `WidgetValueChangedEvent`.
  void SetKind(PickKind kind);
  [[nodiscard]] PickKind GetKind() const { return this->Placer->GetKind(); }
  /// The ratio of placer and representation.
  void SetPixelRatio(double ratio);
  [[nodiscard]] double GetPixelRatio() const { return this->Placer->GetPixelRatio(); }
  /// It finds the point at the cursor. Set its `SnapPixels` here, all else above.
  [[nodiscard]] SurfacePointPlacer* GetPlacer() const { return this->Placer; }

  /// Shows a point as the mouse does, or none, without an event.
  void SetPreview(std::optional<SurfacePick> pick);
  void HidePreview() { this->SetPreview(std::nullopt); }
  [[nodiscard]] const std::optional<SurfacePick>& GetPreview() { return this->Drawn().GetPreview(); }

  /// Whether a key is bound. A window asks this before its shortcuts.
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
