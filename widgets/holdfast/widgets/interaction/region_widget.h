#pragma once
/// Selects regions of a surface: by a brush, a rectangle, a lasso, or a click on a side.

#include <memory>
#include <optional>
#include <vector>

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/screen_selection.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// A closed line over the picture, light below dark, so that it is seen on every surface; or nothing (the default).
class RegionRepresentation : public DrawnByProps<vtkWidgetRepresentation> {
 public:
  static RegionRepresentation* New();
  vtkTypeMacro(RegionRepresentation, vtkWidgetRepresentation)

  /// A polygon that is filled faintly where `ScreenPolygon` has its inside. Corners are pixels as a cursor names them.
  void ShowPolygon(std::vector<DisplayPoint> corners) { this->Show(std::move(corners), true); }
  /// A circle, not filled, around the center of a pixel; radius in pixels of the window.
  void ShowCircle(const DisplayPoint& center, double radius)
  {
    constexpr int kCorners = 72;
    this->Show(circle(center, radius, kCorners), false);
  }
  void ShowNothing() { this->Show({}, false); }
  [[nodiscard]] const std::vector<DisplayPoint>& GetOutline() const { return this->Outline; }

  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  void BuildRepresentation() override;

 protected:
  RegionRepresentation();
  ~RegionRepresentation() override = default;

 private:
  void Show(std::vector<DisplayPoint> outline, bool isFilled);

  std::vector<DisplayPoint> Outline;
  bool IsFilled = false;
  double PixelRatio = 1;
  vtkNew<vtkPolyData> FillData;  // in pixels of the window
  vtkNew<vtkPolyData> LineData;
  vtkNew<vtkActor2D> Fill;
  vtkNew<vtkActor2D> LightLine;
  vtkNew<vtkActor2D> DarkLine;
};

enum class RegionShape {
  Brush,      ///< a stroke reaches the vertices that the brush touches along the surface
  Rectangle,  ///< a drag spans a rectangle: what is seen in it
  Lasso,      ///< a drag draws a line around: what is seen within
  Side        ///< a click: as far as the surface bends by no more than an angle; double: the whole part
};

/// Call data of a `RegionWidget`.
struct RegionCallData {
  std::vector<Index> reached;  ///< vertices of the file, ascending
  SelectionMode mode;          ///< how they are to be joined with what was selected before the gesture
};

/// Holds no selection: an observer keeps the one before a gesture, shows what `joined` makes of it and the call data,
/// and restores it when the gesture is cancelled.
///
/// Shift adds to the selection, Ctrl removes: read at the press of a brush, else at the end of the gesture. With Alt,
/// or by `SetReach`, rectangle and lasso reach hidden vertices as well. Their search takes 12,000 vertices at a time,
/// in turns of the event loop where the interactor has timers. The events of a gesture are aborted; a brush beside the
/// surface and a click on a side leave them to the camera.
class RegionWidget : public WidgetOf<RegionRepresentation> {
 public:
  static RegionWidget* New();
  vtkTypeMacro(RegionWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] RegionRepresentation* GetRegionRepresentation() { return &this->Drawn(); }

  /// `Brush` by default. Another one cancels the gesture under way.
  void SetShape(RegionShape shape);
  [[nodiscard]] RegionShape GetShape() const { return this->Shape; }

  /// The regions are on it; null (the default): nothing. May change at any time; one of another model cancels.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Those of the surface's model; null (the default): no brush and no sides. Another one cancels the gesture.
  void SetRegions(std::shared_ptr<VertexRegions> regions);
  [[nodiscard]] const std::shared_ptr<VertexRegions>& GetRegions() const { return this->Regions; }

  /// The radius of the brush, pixels of a display of ordinary resolution; from 4 to 300, by default 24.
  void SetBrushRadius(double pixels);
  vtkGetMacro(BrushRadius, double);

  /// By how much a side may bend, degrees; from 0 to 175, by default 20.
  vtkSetClampMacro(SideAngle, double, 0.0, 175.0);
  vtkGetMacro(SideAngle, double);

  /// From where that is measured: by default from face to face. The key N changes it.
  void SetBendFrom(BendFrom from) { this->SideBendFrom = from; }
  [[nodiscard]] BendFrom GetBendFrom() const { return this->SideBendFrom; }

  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  /// What rectangle and lasso reach without Alt: `VisibleOnly` by default.
  void SetReach(ScreenReach reach) { this->Reach = reach; }
  [[nodiscard]] ScreenReach GetReach() const { return this->Reach; }

  /// No circle shows the brush until the mouse moves over the surface again. Does nothing during a gesture.
  void HideCircle();

  /// Takes back the gesture under way, as Escape does. False where there is none.
  bool Cancel();

 protected:
  RegionWidget();
  ~RegionWidget() override = default;

  void Inform(RegionRepresentation& representation) override { representation.SetPixelRatio(this->PixelRatio); }
  void Stop() override;

 private:
  enum class Gesture {
    None,
    Stroke,   // of the brush
    Outline,  // is drawn
    Search    // for what is in the outline
  };

  // One for each widget event: whether the VTK event has been used.
  bool Press();
  bool PressAgain() { return this->Shape == RegionShape::Side ? this->SelectPart() : this->Press(); }
  bool MoveTo();
  bool Release();
  void Leave();
  void TimeOut();
  template <int Direction>
  bool Step();
  bool ChangeBendFrom();

  bool BeginStroke();
  void PaintTo(const DisplayPoint& cursor);
  void Dab(const DisplayPoint& pixel);
  void EndOutline();
  void Search();
  bool SelectPart();
  void SelectAtOnce(std::vector<Index> reached);
  void ShowBrush();
  [[nodiscard]] std::vector<DisplayPoint> Polygon() const;
  [[nodiscard]] std::optional<SurfacePick> FaceAt(const DisplayPoint& pixel) const
  {
    return SurfacePicker(this->Surface).pick(*this->CurrentRenderer, pixel.x(), pixel.y(), PickKind::Face, 0);
  }
  void Tell(unsigned long event, std::vector<Index> reached = {});

  RegionShape Shape = RegionShape::Brush;
  std::shared_ptr<const VisibleSurface> Surface;
  std::shared_ptr<VertexRegions> Regions;
  double BrushRadius = 24;
  double SideAngle = 20;
  BendFrom SideBendFrom = BendFrom::Neighbour;
  double PixelRatio = 1;
  ScreenReach Reach = ScreenReach::VisibleOnly;

  Gesture Current = Gesture::None;
  SelectionMode Mode = SelectionMode::Replace;
  std::vector<DisplayPoint> Trail;  // of the cursor since the press
  std::vector<Index> Reached;       // by the stroke
  std::unique_ptr<ScreenSelection> Found;
  int TimerId = 0;
};

}  // namespace holdfast
