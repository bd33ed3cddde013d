#pragma once
/// \file
/// Lets the user choose a point of a surface: on a vertex, on an edge or in a face.

#include <memory>
#include <optional>

#include <vtkNew.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_point_placer.h>
#include <holdfast/widgets/interaction/surface_point_representation.h>

namespace holdfast {

/// Shows the point that a click would take. Clicks are as in `Click`; the second press of a double click begins none.
///
/// | event                   | when                                                    | call data              |
/// |-------------------------|---------------------------------------------------------|------------------------|
/// | InteractionEvent        | at each move over the surface; once when the point goes | `SurfacePick*` or null |
/// | PlacePointEvent         | a click on a point                                      | `SurfacePick*`         |
/// | WidgetValueChangedEvent | a key has chosen what points may lie on                 | `PickKind*`            |
///
/// Keys are those of CharEvent, by which VTK's own styles would quit or fly: those that are used are aborted.
class SurfacePointWidget : public vtkAbstractWidget {
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

  void SetRepresentation(SurfacePointRepresentation* representation);
  [[nodiscard]] SurfacePointRepresentation* GetSurfacePointRepresentation()
  {
    return static_cast<SurfacePointRepresentation*>(this->GetRepresentation());
  }
  void CreateDefaultRepresentation() override;
  /// Disabling hides the point.
  void SetEnabled(int enabling) override;

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
  [[nodiscard]] const std::optional<SurfacePick>& GetPreview()
  {
    return this->GetSurfacePointRepresentation()->GetPreview();
  }

  /// Whether a key is bound. A window asks this before its shortcuts.
  [[nodiscard]] bool WantsKey(char key) const;

 protected:
  SurfacePointWidget();
  ~SurfacePointWidget() override = default;

 private:
  void Hover();
  void Leave();
  void Press();
  void Release();
  template <PickKind Kind>
  void Choose();

  [[nodiscard]] std::optional<SurfacePick> PickAtCursor() const;
  void Show(std::optional<SurfacePick> pick);
  void InformRepresentation();

  vtkNew<SurfacePointPlacer> Placer;
  Click LeftClick;
  bool IsHovering = false;  // the cursor is in the renderer, and nothing moves the camera
};

}  // namespace holdfast
