#pragma once
/// \file
/// Selects regions of a surface: by a brush, a rectangle, a lasso, or a click on a side.

#include <memory>
#include <optional>
#include <vector>

#include <vtkAbstractWidget.h>
#include <vtkCallbackCommand.h>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/interaction/brush_stroke.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/screen_selection.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

class RegionRepresentation;

enum class RegionShape {
  Brush,      ///< a stroke reaches the vertices that the brush touches along the surface
  Rectangle,  ///< a drag spans a rectangle: what is seen in it
  Lasso,      ///< a drag draws a line around: what is seen within
  Side  ///< a click: as far as the surface bends by no more than an angle from face to face; double: the whole part
};

/// What a gesture of a `RegionWidget` has reached.
struct RegionCallData {
  std::vector<Index> reached;  ///< vertices of the file, ascending
  SelectionMode mode;          ///< how they are to be joined with what was selected before the gesture
};

/// Holds no selection: an observer keeps what was selected when a gesture begins, shows what `joined` makes of it and
/// of the call data, and shows it alone again when the gesture is cancelled.
///
/// | event                   | when                                                           | call data         |
/// |-------------------------|----------------------------------------------------------------|-------------------|
/// | StartInteractionEvent   | a gesture begins; nothing is reached yet                       | `RegionCallData*` |
/// | InteractionEvent        | the brush has been led on, the first time where it came down   | `RegionCallData*` |
/// | EndInteractionEvent     | all that the gesture reaches is known                          | `RegionCallData*` |
/// | CancelInteractionEvent  | instead: Escape, an outline too small, another press, another  | `RegionCallData*` |
/// |                         | shape, regions or model, disabled                              |                   |
/// | WidgetValueChangedEvent | a key asks for another radius of the brush or angle of sides   | none              |
///
/// Bindings, which the event translator can change: docs/widgets.md.
///
/// Shift adds to what is selected, Ctrl takes away: of a brush as it comes down, else at the end of the gesture. With
/// Alt, rectangle and lasso reach what is hidden as well. What they reach is looked for 12,000 vertices at a time, in
/// turns of the event loop where the interactor has timers. The press is aborted, and all that follows it, where a
/// gesture begins there: that of a brush beside the surface, and a click on a side, are left to the camera.
class RegionWidget : public vtkAbstractWidget {
 public:
  static RegionWidget* New();
  vtkTypeMacro(RegionWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetRepresentation(RegionRepresentation* representation);
  [[nodiscard]] RegionRepresentation* GetRegionRepresentation();
  void CreateDefaultRepresentation() override;
  /// Disabling cancels what is under way.
  void SetEnabled(int enabling) override;

  /// `Brush` by default. Another one cancels what is under way.
  void SetShape(RegionShape shape);
  [[nodiscard]] RegionShape GetShape() const { return this->Shape; }

  /// Where regions lie; null (the default): nowhere. May change at any time; that of another model cancels.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Of the surface's model; null (the default): no brush and no sides. Others cancel what is under way.
  void SetRegions(std::shared_ptr<VertexRegions> regions);
  [[nodiscard]] const std::shared_ptr<VertexRegions>& GetRegions() const { return this->Regions; }

  /// Of the brush, pixels of a display of ordinary resolution; from 4 to 300, by default 24.
  void SetBrushRadius(double pixels);
  vtkGetMacro(BrushRadius, double);

  /// By how much a side may bend from face to face, degrees; from 0 to 175, by default 20.
  void SetSideAngle(double degrees);
  vtkGetMacro(SideAngle, double);

  /// Pixels of the window for each of a display of ordinary resolution; 1 by default.
  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  /// Takes back the gesture that is under way, as Escape does. False where there is none.
  bool Cancel();

 protected:
  RegionWidget();
  ~RegionWidget() override = default;

 private:
  enum class Gesture {
    None,
    Stroke,   // of the brush
    Outline,  // is drawn
    Search    // for what is in the outline
  };

  void Press();
  void PressAgain();
  void MoveTo();
  void Release();
  void Leave();
  void Escape()
  {
    if (this->Cancel()) this->Use();
  }
  void TimeOut();

  void BeginStroke();
  void PaintTo(const DisplayPoint& cursor);
  void BeginOutline();
  void EndOutline();
  void Search();
  void SelectSide();
  void SelectPart();
  void SelectAtOnce(std::vector<Index> reached);

  template <int Direction>
  void Step();
  void Use() { this->EventCallbackCommand->SetAbortFlag(1); }
  void Hover();
  void ShowBrush();
  void ShowOutline();
  [[nodiscard]] std::vector<DisplayPoint> Polygon() const;
  [[nodiscard]] std::optional<SurfacePick> FaceUnderCursor() const;
  void Tell(unsigned long event, std::vector<Index> reached);

  RegionShape Shape = RegionShape::Brush;
  std::shared_ptr<const VisibleSurface> Surface;
  std::shared_ptr<VertexRegions> Regions;
  double BrushRadius = 24;
  double SideAngle = 20;
  double PixelRatio = 1;

  Gesture Current = Gesture::None;
  Click LeftClick;  // on a side
  SelectionMode Mode = SelectionMode::Replace;
  std::vector<DisplayPoint> Trail;  // of the cursor since the press
  std::optional<BrushStroke> Stroke;
  std::unique_ptr<ScreenSelection> Found;
  int TimerId = 0;
};

}  // namespace holdfast
