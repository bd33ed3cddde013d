#pragma once
/// Measures between two points of a surface.

#include <memory>
#include <optional>
#include <string>

#include <vtkActor2D.h>
#include <vtkDistanceRepresentation2D.h>
#include <vtkDistanceWidget.h>
#include <vtkNew.h>
#include <vtkPointHandleRepresentation2D.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_point_placer.h>
#include <holdfast/widgets/picking/surface_picker.h>

namespace holdfast {

/// A place on a surface, as it was named and as it is computed with.
struct SurfacePlacement {
  SurfaceLocation location;
  SurfacePoint point;
};

/// Placed by a `SurfacePointPlacer`, it keeps its location on the surface. Beside the surface it stays where it was.
class SurfaceHandleRepresentation : public vtkPointHandleRepresentation2D {
 public:
  static SurfaceHandleRepresentation* New();
  vtkTypeMacro(SurfaceHandleRepresentation, vtkPointHandleRepresentation2D)

  /// None before it is placed.
  [[nodiscard]] const std::optional<SurfacePlacement>& GetPlacement() const { return this->Placement; }
  void SetPlacement(std::optional<SurfacePlacement> placement);

  /// On the placer's surface. Throws `InputError` for a location that the mesh does not have. O(T log T).
  [[nodiscard]] SurfacePlacement PlacementAt(const SurfaceLocation& location) const;
  void SetLocation(const SurfaceLocation& location);

  /// Call it when the placer has another surface of the same mesh.
  void FollowSurface();

  /// Its place at rest and now, model units. It is placed.
  [[nodiscard]] Vector3 GetRestPlace() const
  {
    return positionOf(this->Placement->point, this->GetSurface()->model().mesh.positions);
  }
  [[nodiscard]] Vector3 GetPlace() const { return positionOf(this->Placement->point, this->GetSurface()->positions()); }

  void SetDisplayPosition(double display[3]) override;

 protected:
  SurfaceHandleRepresentation() = default;
  ~SurfaceHandleRepresentation() override = default;

 private:
  [[nodiscard]] const VisibleSurface* GetSurface() const;

  std::optional<SurfacePlacement> Placement;
};

/// A line with a ring at each end, on top of the picture, and a label with the distance now and at rest, as
/// "12.34 mm (rest 11.98)". With `ShowVector` the line is an arrow to end 1, and the label has its components:
/// "5 mm: 3, 0, 4 (rest 4.9)".
class SurfaceRulerRepresentation : public vtkDistanceRepresentation2D {
 public:
  static SurfaceRulerRepresentation* New();
  vtkTypeMacro(SurfaceRulerRepresentation, vtkDistanceRepresentation2D)

  /// Places both ends. Set its surface and its ratio of pixels below.
  [[nodiscard]] SurfacePointPlacer* GetPlacer() const { return this->Placer; }

  /// The ends move with it, and are removed where it is another mesh's.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);

  /// The ends, 0 and 1.
  [[nodiscard]] SurfaceHandleRepresentation& GetHandle(int end) const
  {
    return *static_cast<SurfaceHandleRepresentation*>(end == 0 ? this->Point1Representation
                                                               : this->Point2Representation);
  }
  /// Whether both are placed.
  [[nodiscard]] bool IsPlaced() const { return this->GetHandle(0).GetPlacement() && this->GetHandle(1).GetPlacement(); }

  /// Model units; 0 before both ends are placed.
  double GetDistance() override { return this->GetVector().stableNorm(); }
  [[nodiscard]] double GetRestDistance() const
  {
    return this->IsPlaced() ? (this->GetHandle(0).GetRestPlace() - this->GetHandle(1).GetRestPlace()).stableNorm() : 0;
  }
  /// From end 0 to end 1; zero before both are placed.
  [[nodiscard]] Vector3 GetVector() const
  {
    return this->IsPlaced() ? Vector3(this->GetHandle(1).GetPlace() - this->GetHandle(0).GetPlace()) : Vector3::Zero();
  }

  /// Off by default.
  vtkSetMacro(ShowVector, bool);
  vtkGetMacro(ShowVector, bool);
  vtkBooleanMacro(ShowVector, bool);

  /// The user's name of the model's length, in UTF-8; empty by default.
  vtkSetMacro(Units, std::string);
  [[nodiscard]] const std::string& GetUnits() const { return this->Units; }
  [[nodiscard]] std::string GetLabel();
  /// Whether VTK draws the label; on by default. A window that writes in a font of its own switches it off.
  vtkSetMacro(LabelVisibility, bool);
  vtkBooleanMacro(LabelVisibility, bool);

  /// dots per inch do not count.
  void SetPixelRatio(double ratio);
  [[nodiscard]] double GetPixelRatio() const { return this->Placer->GetPixelRatio(); }

  void BuildRepresentation() override;
  void GetActors2D(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;

 protected:
  SurfaceRulerRepresentation();
  ~SurfaceRulerRepresentation() override = default;

 private:
  void BuildLines();

  vtkNew<SurfacePointPlacer> Placer;
  std::string Units;
  bool ShowVector = false;
  bool LabelVisibility = true;
  bool IsInView = false;      // both ends are in front of the eye
  vtkNew<vtkPolyData> Lines;  // in pixels of the window
  vtkNew<vtkActor2D> Halo;
  vtkNew<vtkActor2D> Line;
};

/// A click on the surface places the first end, another one the second; then both can be dragged, and a click beside
/// them begins another ruler (`NextRulerEvent` before it). Ends are on vertices,
/// on edges or in faces, and move with the surface. Clicks are as in `Click`. A drag of an end aborts its events.
class SurfaceRulerWidget : public WidgetOf<SurfaceRulerRepresentation, vtkDistanceWidget> {
 public:
  static SurfaceRulerWidget* New();
  vtkTypeMacro(SurfaceRulerWidget, vtkDistanceWidget)

  [[nodiscard]] SurfaceRulerRepresentation* GetRulerRepresentation() { return &this->Drawn(); }
  /// Disabling cancels a drag or a half-drawn ruler, and keeps a complete one.
  void SetEnabled(int enabling) override;

  /// Null (the default): nothing is measured. The ends move with it; the ruler is removed where it is another mesh's.
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
