#pragma once
/// Selects regions of a surface by a brush, a rectangle, a lasso, or a click on a side.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastRegionRepresentation.h>
#include <holdfast/widgets/picking/screen_selection.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// How a region is drawn, and what of the surface the gesture reaches.
enum class RegionShape {
  Brush,      ///< a stroke reaches the vertices that the brush touches along the surface
  Rectangle,  ///< a drag spans a rectangle, which reaches what is seen in it
  Lasso,      ///< a drag draws a line, which reaches what is seen within
  Side        ///< a click reaches as far as the surface bends by no more than an angle;
              ///< a double click reaches the whole connected part
};

/// The call data of the gesture events of a `vtkHoldfastRegionWidget`.
struct RegionCallData {
  std::vector<Index> reached;  ///< vertices of the file, ascending
  SelectionMode mode;          ///< how they are to be joined with what was selected before the gesture
};

}  // namespace holdfast

/// Reports the vertices that a gesture reaches. It holds no selection: an observer keeps the selection from before the
/// gesture. The observer shows what `joined` makes of that selection and the call data. It restores the selection when
/// the gesture is cancelled.
///
///     vtkNew<vtkHoldfastRegionWidget> region;
///     region->SetInteractor(interactor);
///     region->SetSurface(surface);
///     region->SetRegions(std::make_shared<VertexRegions>(model.mesh, model.solverMesh));
///     region->SetShape(RegionShape::Brush);
///     region->AddObserver(vtkCommand::InteractionEvent, &tool, &Tool::select);  // call data: `RegionCallData*`
///     region->On();
///
/// Shift adds to the selection, Ctrl removes from it. A brush reads these keys at the press, other shapes at the end of
/// the gesture. With Alt, or by `SetReach`, rectangle and lasso reach hidden vertices as well. Their search takes
/// 12,000 vertices at a time, in turns of the event loop where the interactor has timers.
///
/// These are the bindings, each with its widget event:
///
///     MouseMoveEvent                    Move: goes on with the gesture, or shows the brush under the cursor
///     LeaveEvent                        HoverLeave: hides the brush
///     LeftButtonPressEvent              Select: begins a gesture
///     LeftButtonDoubleClickEvent        Completed: selects the whole connected part (`Side`); else as a press
///     LeftButtonReleaseEvent            EndSelect: ends the gesture
///     KeyPressEvent bracketleft         Down: makes the brush smaller, or the angle of a side
///     KeyPressEvent bracketright        Up: makes the brush larger, or the angle of a side
///     KeyPressEvent n                   ModifyEvent: changes from where the angle of a side is measured
///     KeyPressEvent Escape              Reset: takes back the gesture
///     TimerEvent                        TimedOut: goes on with the search of rectangle or lasso
///
/// These are the events that it invokes. The call data of the first four are a `RegionCallData*`; the last has none:
///
///     StartInteractionEvent     a gesture begins; nothing is reached yet
///     InteractionEvent          the brush has moved on; `reached` is all of the stroke so far
///     EndInteractionEvent       the gesture is complete, and `reached` with it
///     CancelInteractionEvent    the gesture was taken back, or its outline was too small; `reached` is empty
///     WidgetValueChangedEvent   a key has asked for another radius or angle, or to measure the angle from elsewhere
///
/// The widget aborts the events of a gesture. A brush beside the surface and a click on a side leave their events to
/// the camera.
class vtkHoldfastRegionWidget : public holdfast::WidgetOf<vtkHoldfastRegionRepresentation> {
 public:
  static vtkHoldfastRegionWidget* New();
  vtkTypeMacro(vtkHoldfastRegionWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] vtkHoldfastRegionRepresentation* GetRegionRepresentation() { return &this->Drawn(); }

  /// Sets the shape; `Brush` by default. Another shape cancels the gesture under way.
  void SetShape(holdfast::RegionShape shape);
  [[nodiscard]] holdfast::RegionShape GetShape() const { return this->Shape; }

  /// Sets the surface on which regions are selected. With null, the default, nothing is selected. It may change at any
  /// time, but a surface of another model cancels the gesture.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const holdfast::VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Sets the regions of the surface's model. With null, the default, there are no brush and no sides. Other regions
  /// cancel the gesture.
  void SetRegions(std::shared_ptr<holdfast::VertexRegions> regions);
  [[nodiscard]] const std::shared_ptr<holdfast::VertexRegions>& GetRegions() const { return this->Regions; }

  /// Sets the radius of the brush, in pixels of a display of ordinary resolution: from 4 to 300, by default 24.
  void SetBrushRadius(double pixels);
  vtkGetMacro(BrushRadius, double);

  /// Sets by how much a side may bend, in degrees: from 0 to 175, by default 20.
  vtkSetClampMacro(SideAngle, double, 0.0, 175.0);
  vtkGetMacro(SideAngle, double);

  /// Sets from where that angle is measured; by default it is measured from face to face. The key n changes this.
  void SetBendFrom(holdfast::BendFrom from) { this->SideBendFrom = from; }
  [[nodiscard]] holdfast::BendFrom GetBendFrom() const { return this->SideBendFrom; }

  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  /// Sets what rectangle and lasso reach without Alt; `VisibleOnly` by default.
  void SetReach(holdfast::ScreenReach reach) { this->Reach = reach; }
  [[nodiscard]] holdfast::ScreenReach GetReach() const { return this->Reach; }

  /// Hides the circle of the brush until the mouse moves over the surface again. It does nothing while a stroke or an
  /// outline is drawn.
  void HideCircle();

  /// Takes back the gesture under way, as Escape does. It returns false where there is none.
  bool Cancel();

 protected:
  vtkHoldfastRegionWidget();
  ~vtkHoldfastRegionWidget() override = default;

  void Inform(vtkHoldfastRegionRepresentation& representation) override
  {
    representation.SetPixelRatio(this->PixelRatio);
  }
  void Stop() override;

 private:
  enum class Gesture {
    None,
    Stroke,   // of the brush
    Outline,  // is drawn
    Search    // for what is in the outline
  };

  // There is one for each widget event. It returns whether it has used the VTK event.
  bool Press();
  bool PressAgain() { return this->Shape == holdfast::RegionShape::Side ? this->SelectPart() : this->Press(); }
  bool MoveTo();
  bool Release();
  void Leave();
  void TimeOut();
  template <int Direction>
  bool Step();
  bool ChangeBendFrom();

  bool BeginStroke();
  void PaintTo(const holdfast::DisplayPoint& cursor);
  void Dab(const holdfast::DisplayPoint& pixel);
  void EndOutline();
  void Search();
  bool SelectPart();
  void SelectAtOnce(std::vector<holdfast::Index> reached);
  void ShowBrush();
  [[nodiscard]] std::vector<holdfast::DisplayPoint> Polygon() const;
  [[nodiscard]] std::optional<holdfast::SurfacePick> FaceAt(const holdfast::DisplayPoint& pixel) const
  {
    return holdfast::SurfacePicker(this->Surface)
        .pick(*this->CurrentRenderer, pixel.x(), pixel.y(), holdfast::PickKind::Face, 0);
  }
  void Tell(unsigned long event, std::vector<holdfast::Index> reached = {});

  holdfast::RegionShape Shape = holdfast::RegionShape::Brush;
  std::shared_ptr<const holdfast::VisibleSurface> Surface;
  std::shared_ptr<holdfast::VertexRegions> Regions;
  double BrushRadius = 24;
  double SideAngle = 20;
  holdfast::BendFrom SideBendFrom = holdfast::BendFrom::Neighbour;
  double PixelRatio = 1;
  holdfast::ScreenReach Reach = holdfast::ScreenReach::VisibleOnly;

  Gesture Current = Gesture::None;
  holdfast::SelectionMode Mode = holdfast::SelectionMode::Replace;
  std::vector<holdfast::DisplayPoint> Trail;  // of the cursor since the press
  std::vector<holdfast::Index> Reached;       // by the stroke
  std::unique_ptr<holdfast::ScreenSelection> Found;
  int TimerId = 0;
};
