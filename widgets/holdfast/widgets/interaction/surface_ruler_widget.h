#pragma once
/// Measures between two points of a surface.

#include <memory>
#include <optional>
#include <string>

#include <vtkDistanceWidget.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_ruler_representation.h>

namespace holdfast {

/// A click on the surface places the first end, another one the second; then both can be dragged. Ends are on vertices,
/// on edges or in faces, and move with the surface. Clicks are as in `Click`. A drag of an end aborts its events.
class SurfaceRulerWidget : public WidgetOf<SurfaceRulerRepresentation, vtkDistanceWidget> {
 public:
  static SurfaceRulerWidget* New();
  vtkTypeMacro(SurfaceRulerWidget, vtkDistanceWidget)

  [[nodiscard]] SurfaceRulerRepresentation* GetRulerRepresentation() { return &this->Drawn(); }
  /// Disabling cancels a drag or a half-drawn ruler, and keeps a complete one.
  void SetEnabled(int enabling) override;

  /// Null (the default): nothing is measured. May change at any time: the ends move with it, and the ruler is removed
  /// where it is another mesh's (`VisibleSurface::isSameMesh`).
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }
  void SetUnits(const std::string& units) { this->Drawn().SetUnits(units); }
  [[nodiscard]] SurfacePointPlacer* GetPlacer() { return this->Drawn().GetPlacer(); }

  /// A ruler from `a` to `b`, without events. There is a surface. Throws `InputError`, and changes nothing, where the
  /// mesh does not have a location. O(T log T).
  void SetLocations(const SurfaceLocation& a, const SurfaceLocation& b);
  /// The picks of the ends 0 and 1; none while they are not placed.
  [[nodiscard]] std::optional<SurfaceLocation> GetLocation(int end);
  /// No ruler: the next click places its first end. Without events.
  void Clear();

  /// Model units; 0 before both ends are placed.
  [[nodiscard]] double GetDistance() { return this->Drawn().GetDistance(); }
  [[nodiscard]] double GetRestDistance() { return this->Drawn().GetRestDistance(); }

  /// Whether the first end is placed and the second goes with the cursor, or an end is dragged.
  [[nodiscard]] bool IsUnderWay() const { return this->WidgetState == vtkDistanceWidget::Define || this->GrabbedAt; }
  /// As Escape does. False where nothing is under way.
  bool Cancel();

 protected:
  SurfaceRulerWidget();
  ~SurfaceRulerWidget() override = default;

 private:
  void Press();
  void Move();
  void Release();

  void Hover();
  void StopDrag();
  void PrepareHandles();

  std::optional<SurfacePlacement> GrabbedAt;  // where the end was that is dragged
};

}  // namespace holdfast
