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

/// A place on a surface: as it was named, and as the program computes with it.
struct SurfacePlacement {
  SurfaceLocation location;
  SurfacePoint point;
};

/// A handle that keeps its location on the surface. A `SurfacePointPlacer` places it. Beside the surface it stays where
/// it was.
///
///     vtkNew<SurfaceHandleRepresentation> drawn;
///     drawn->SetPointPlacer(placer);  // a `SurfacePointPlacer` that has a surface
///     drawn->SetLocation(AtVertex{0});
///     handle->SetRepresentation(drawn);  // a vtkHandleWidget
class SurfaceHandleRepresentation : public vtkPointHandleRepresentation2D {
 public:
  static SurfaceHandleRepresentation* New();
  vtkTypeMacro(SurfaceHandleRepresentation, vtkPointHandleRepresentation2D)

  /// Returns where the handle is; none before it is placed.
  [[nodiscard]] const std::optional<SurfacePlacement>& GetPlacement() const { return this->Placement; }
  void SetPlacement(std::optional<SurfacePlacement> placement);

  /// `PlacementAt` finds a location on the placer's surface, and `SetLocation` places the handle there. The placer has
  /// a surface. Both throw `InputError` for a location that the mesh does not have. O(T log T).
  [[nodiscard]] SurfacePlacement PlacementAt(const SurfaceLocation& location) const;
  void SetLocation(const SurfaceLocation& location);

  /// Moves the handle with the surface. Call it when the placer has another surface of the same mesh.
  void FollowSurface();

  /// Return the handle's place at rest and its place now, in model units. The handle is placed.
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

/// Draws a line with a ring at each end, on top of the picture. A label has the distance now and at rest, as "12.34 mm
/// (rest 11.98)". With `ShowVector` the line is an arrow to end 1, and the label has its components: "5 mm: 3, 0, 4
/// (rest 4.9)".
class SurfaceRulerRepresentation : public vtkDistanceRepresentation2D {
 public:
  static SurfaceRulerRepresentation* New();
  vtkTypeMacro(SurfaceRulerRepresentation, vtkDistanceRepresentation2D)

  /// Returns the placer of both ends. Set its surface and its ratio of pixels by the functions below.
  [[nodiscard]] SurfacePointPlacer* GetPlacer() const { return this->Placer; }

  /// Sets the surface. The ends move with it, and are removed where it is that of another mesh.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);

  /// Returns an end, 0 or 1.
  [[nodiscard]] SurfaceHandleRepresentation& GetHandle(int end) const
  {
    return *static_cast<SurfaceHandleRepresentation*>(end == 0 ? this->Point1Representation
                                                               : this->Point2Representation);
  }
  /// Tells whether both ends are placed.
  [[nodiscard]] bool IsPlaced() const { return this->GetHandle(0).GetPlacement() && this->GetHandle(1).GetPlacement(); }

  /// Return the distance now and at rest, in model units; 0 before both ends are placed.
  double GetDistance() override { return this->GetVector().stableNorm(); }
  [[nodiscard]] double GetRestDistance() const
  {
    return this->IsPlaced() ? (this->GetHandle(0).GetRestPlace() - this->GetHandle(1).GetRestPlace()).stableNorm() : 0;
  }
  /// Returns the vector from end 0 to end 1; zero before both are placed.
  [[nodiscard]] Vector3 GetVector() const
  {
    return this->IsPlaced() ? Vector3(this->GetHandle(1).GetPlace() - this->GetHandle(0).GetPlace()) : Vector3::Zero();
  }

  /// Sets whether the line is an arrow and the label has its components; off by default.
  vtkSetMacro(ShowVector, bool);
  vtkGetMacro(ShowVector, bool);
  vtkBooleanMacro(ShowVector, bool);

  /// Sets the user's name of the model's length, in UTF-8; empty by default.
  vtkSetMacro(Units, std::string);
  [[nodiscard]] const std::string& GetUnits() const { return this->Units; }
  [[nodiscard]] std::string GetLabel();
  /// Sets whether VTK draws the label; on by default. A window that writes in a font of its own switches it off.
  vtkSetMacro(LabelVisibility, bool);
  vtkBooleanMacro(LabelVisibility, bool);

  /// Sets the number of window pixels for each pixel of ordinary resolution. The window's dots per inch do not change
  /// sizes.
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

/// Measures between two points of a surface. A click on the surface places the first end, another one the second. Then
/// both ends can be dragged. A click beside them begins another ruler, with `NextRulerEvent` before it.
///
///     vtkNew<SurfaceRulerWidget> ruler;
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
class SurfaceRulerWidget : public WidgetOf<SurfaceRulerRepresentation, vtkDistanceWidget> {
 public:
  static SurfaceRulerWidget* New();
  vtkTypeMacro(SurfaceRulerWidget, vtkDistanceWidget)

  [[nodiscard]] SurfaceRulerRepresentation* GetRulerRepresentation() { return &this->Drawn(); }
  /// Enables or disables the widget. Disabling cancels a drag or a half-drawn ruler, and keeps a complete one.
  void SetEnabled(int enabling) override;

  /// Sets the surface; with null, the default, nothing is measured. The ends move with it. The ruler is removed where
  /// the surface is that of another mesh.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }
  void SetUnits(const std::string& units) { this->Drawn().SetUnits(units); }
  [[nodiscard]] SurfacePointPlacer* GetPlacer() { return this->Drawn().GetPlacer(); }

  /// Makes a ruler from `a` to `b`. Set a surface first: without one VTK reports an error, and nothing changes. The
  /// call takes back what is under way, as `Cancel` does, and invokes no other events. It throws `InputError`, and
  /// changes nothing more, where the mesh does not have a location. O(T log T).
  void SetLocations(const SurfaceLocation& a, const SurfaceLocation& b);
  /// Returns the location of end 0 or 1; none while it is not placed.
  [[nodiscard]] std::optional<SurfaceLocation> GetLocation(int end);
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
  SurfaceRulerWidget();
  ~SurfaceRulerWidget() override = default;

 private:
  void Press();
  void Move();
  void Release();

  void Hover();
  void StopDrag();
  void PrepareHandles();

  std::optional<SurfacePlacement> GrabbedAt;  // where the end that is dragged was before
};

}  // namespace holdfast
