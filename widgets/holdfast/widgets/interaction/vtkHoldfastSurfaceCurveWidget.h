#pragma once
/// Draws closed curves along the edges of a surface.

#include <memory>
#include <utility>
#include <vector>

#include <vtkContourRepresentation.h>
#include <vtkContourWidget.h>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCurveRepresentation.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Draws a closed curve along the edges of a surface. Clicks place vertices, which shortest paths of edges join. A
/// click within 12 pixels of the first vertex closes the curve. Then its places can be dragged, and a drag from
/// elsewhere on it adds one. A click is as `Click` describes.
///
///     vtkNew<vtkHoldfastSurfaceCurveWidget> curve;
///     curve->SetInteractor(interactor);
///     curve->SetSurface(surface);
///     curve->SetRegions(std::make_shared<VertexRegions>(model.mesh, model.solverMesh));
///     curve->AddObserver(vtkCommand::EndInteractionEvent, &tool, &Tool::cut);  // call data: `std::vector<Index>*`
///     curve->On();
///
/// These are the bindings, each with its widget event:
///
///     MouseMoveEvent                    Move: shows the way to the vertex under the cursor, or drags a place
///     LeaveEvent                        HoverLeave: hides that way
///     LeftButtonPressEvent              Select: begins a click, or a drag on a closed curve
///     LeftButtonReleaseEvent            EndSelect: places a vertex, closes the curve, or ends the drag
///     LeftButtonDoubleClickEvent        AddFinalPoint: closes the curve
///     KeyPressEvent Return, KP_Enter    AddFinalPoint: closes the curve
///     KeyPressEvent BackSpace, Delete   Delete: removes the place under the cursor (closed curve), else the last one
///     KeyPressEvent Escape              Reset: takes back a drag, or else all places
///
/// These are the events that it invokes. But for PlacePointEvent, their call data are all places,
/// `std::vector<Index>*`:
///
///     StartInteractionEvent     the first place is put, or a drag begins
///     PlacePointEvent           a place is put at the end; call data: `Index*`, its vertex
///     InteractionEvent          a place was dragged to another vertex
///     WidgetValueChangedEvent   the curve has changed by mouse or keys, Escape excepted
///     EndInteractionEvent       the curve is closed, or a drag ends
///     CancelInteractionEvent    a drag or all places were taken back
///
/// `FollowCursor`, on by default, shows the way to the vertex under the cursor. `ContinuousDraw` and `AllowNodePicking`
/// have no effect. `CloseLoop` closes the curve without an event. Disabling keeps the curve.
class vtkHoldfastSurfaceCurveWidget
    : public holdfast::WidgetOf<vtkHoldfastSurfaceCurveRepresentation, vtkContourWidget> {
 public:
  static vtkHoldfastSurfaceCurveWidget* New();
  vtkTypeMacro(vtkHoldfastSurfaceCurveWidget, vtkContourWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] vtkHoldfastSurfaceCurveRepresentation* GetSurfaceCurveRepresentation() { return &this->Drawn(); }
  void SetEnabled(int enabling) override;

  /// Sets the surface; with null, the default, there is no curve. Positions may change at any time. A surface of
  /// another model removes the curve.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface);
  /// Sets the regions of the surface's model, whose edges the curve follows. With null, the default, clicks are
  /// refused.
  void SetRegions(std::shared_ptr<const holdfast::VertexRegions> regions)
  {
    this->Drawn().SetRegions(std::move(regions));
  }
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }
  [[nodiscard]] double GetPixelRatio() { return this->Drawn().GetPixelRatio(); }

  /// Return what the representation returns: the places, and the places with all vertices between.
  [[nodiscard]] std::vector<holdfast::Index> GetPlaces() { return this->Drawn().GetPlaces(); }
  [[nodiscard]] std::vector<holdfast::Index> GetPath() { return this->Drawn().GetPath(); }
  [[nodiscard]] bool IsClosed() { return this->Drawn().GetClosedLoop() != 0; }

  /// Makes an open curve through these vertices instead, without an event. Call it after surface and regions are set.
  /// It returns false, and there is no curve, where a vertex cannot be a place
  /// (`vtkHoldfastSurfaceCurveRepresentation::InsertPlace`).
  bool SetPlaces(const std::vector<holdfast::Index>& vertices);
  /// Removes the curve, without an event.
  void Clear();

  // The functions below do what mouse and keys do, with the same events.

  /// Puts a place at the end of an open curve. It returns false where that is not possible.
  bool AddPlace(holdfast::Index vertex);
  /// Closes the curve. It returns false for a closed curve, and for fewer than three places.
  bool Close();
  /// Takes the last place back, after which the curve is open. It returns false where there is none.
  bool RemoveLast();
  /// Takes a drag back, or else all places. It returns false where there are none.
  bool Cancel();

  /// Makes a curve as VTK's function does, from points near vertices or, better, from `vertices`. An open line can be
  /// continued.
  void Initialize(vtkPolyData* line, int state = 1, vtkIdList* vertices = nullptr) override;
  using vtkContourWidget::Initialize;

 protected:
  vtkHoldfastSurfaceCurveWidget();
  ~vtkHoldfastSurfaceCurveWidget() override = default;

  void Stop() override;

 private:
  // There is one for each widget event. It returns whether it has used the VTK event.
  bool Press();
  bool MoveTo();
  bool Release();
  void Leave();
  bool RemoveByHand();

  bool BeginDrag();
  void Hover(const holdfast::DisplayPoint& cursor);
  void Changed();
  void Tell(unsigned long event);
  void ShowChanges();
  [[nodiscard]] bool IsDragging() { return this->Drawn().GetCurrentOperation() != vtkContourRepresentation::Inactive; }

  std::vector<holdfast::Index> PlacesBefore;  // as they were before the drag that is under way
};
