#pragma once
/// Draws closed curves along the edges of a surface.

#include <memory>
#include <optional>
#include <vector>

#include <vtkContourRepresentation.h>
#include <vtkContourWidget.h>
#include <vtkNew.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_point_placer.h>
#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/actors.h>

namespace holdfast {

/// Draws a contour along the edges of a surface. Its nodes, the places, are different vertices of one connected part of
/// the surface.
class SurfaceCurveRepresentation : public DrawnByProps<vtkContourRepresentation> {
 public:
  static SurfaceCurveRepresentation* New();
  vtkTypeMacro(SurfaceCurveRepresentation, vtkContourRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the surface; with null, the default, there is no curve. A surface of another model removes the curve.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  /// Sets the regions, made of the surface's model, whose edges the curve follows. With null, the default, places are
  /// refused.
  void SetRegions(std::shared_ptr<const VertexRegions> regions) { this->Interpolator->SetRegions(std::move(regions)); }

  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  /// Return vertices of the file in order. `GetPlaces` returns the places alone, `GetPath` the places with all vertices
  /// between. For a closed curve the path includes the vertices from the last place to the first.
  [[nodiscard]] std::vector<Index> GetPlaces() const;
  [[nodiscard]] std::vector<Index> GetPath() const;

  /// `InsertPlace` inserts a place before the `n`-th one, `MovePlace` moves that one. Both return false, and change
  /// nothing, for three kinds of vertices. These are a vertex that no face uses, one that is a place already, and one
  /// to which no edges lead from the others.
  bool InsertPlace(int n, std::optional<Index> vertex);
  bool MovePlace(int n, std::optional<Index> vertex);

  /// Returns the vertex for a click on a pixel. `SurfacePicker` finds it within 12 pixels. Beside the surface there is
  /// none.
  [[nodiscard]] std::optional<Index> VertexAt(const DisplayPoint& pixel) const;
  /// Tells whether a click on the pixel closes the curve. It does where the first of three places or more is within 12
  /// pixels.
  [[nodiscard]] bool IsAtFirst(const DisplayPoint& pixel);
  [[nodiscard]] bool IsClosable() const;

  /// Shows the path from the last place to a vertex. Where there is no place yet, it shows that vertex alone.
  void SetPreview(std::optional<Index> vertex);
  [[nodiscard]] const std::vector<Index>& GetPreview() const { return this->Preview; }

  // These are VTK's functions for nodes. A place in space means the nearest vertex, O(N).
  using vtkContourRepresentation::ActivateNode;
  using vtkContourRepresentation::AddIntermediatePointWorldPosition;
  using vtkContourRepresentation::AddNodeAtDisplayPosition;
  using vtkContourRepresentation::AddNodeAtWorldPosition;
  using vtkContourRepresentation::SetActiveNodeToDisplayPosition;
  using vtkContourRepresentation::SetNthNodeDisplayPosition;
  int AddNodeAtWorldPosition(double place[3]) override
  {
    return this->InsertPlace(this->GetNumberOfNodes(), this->NearestVertex(place));
  }
  int AddNodeAtWorldPosition(double place[3], double* /*orientation*/) override
  {
    return this->AddNodeAtWorldPosition(place);
  }
  int AddNodeAtDisplayPosition(double pixel[2]) override
  {
    return this->InsertPlace(this->GetNumberOfNodes(), this->VertexAt(DisplayPoint(pixel)));
  }
  int AddNodeOnContour(int x, int y) override;
  int SetNthNodeWorldPosition(int n, double place[3]) override
  {
    return this->MovePlace(n, this->NearestVertex(place));
  }
  int SetNthNodeWorldPosition(int n, double place[3], double* /*orientation*/) override
  {
    return this->SetNthNodeWorldPosition(n, place);
  }
  int SetNthNodeDisplayPosition(int n, double pixel[2]) override
  {
    return this->MovePlace(n, this->VertexAt(DisplayPoint(pixel)));
  }
  int SetActiveNodeToWorldPosition(double place[3]) override
  {
    return this->SetNthNodeWorldPosition(this->ActiveNode, place);
  }
  int SetActiveNodeToWorldPosition(double place[3], double* /*orientation*/) override
  {
    return this->SetActiveNodeToWorldPosition(place);
  }
  int SetActiveNodeToDisplayPosition(double pixel[2]) override
  {
    return this->SetNthNodeDisplayPosition(this->ActiveNode, pixel);
  }
  int AddIntermediatePointWorldPosition(int n, double place[3], vtkIdType vertex) override;
  /// Makes the nearest visible place within 12 pixels the active one, and returns 1. Without one it returns 0, and no
  /// place is active.
  int ActivateNode(double pixel[2]) override;
  void ClearAllNodes() override;

  void BuildRepresentation() override;
  int ComputeInteractionState(int x, int y, int modified = 0) override;
  void StartWidgetInteraction(double /*pixel*/[2]) override {}
  /// Takes the active place to the vertex under the cursor, while that place is translated.
  void WidgetInteraction(double pixel[2]) override;
  vtkPolyData* GetContourRepresentationAsPolyData() override;

  int RenderTranslucentPolygonalGeometry(vtkViewport* /*viewport*/) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }

 protected:
  SurfaceCurveRepresentation();
  ~SurfaceCurveRepresentation() override = default;

  void BuildLines() override { this->Modified(); }
  void InitializeContour(vtkPolyData* line, vtkIdList* vertices) override;

 private:
  [[nodiscard]] bool IsPossible(Index vertex, int moved) const;
  [[nodiscard]] std::optional<Index> NearestVertex(const double place[3]) const;
  [[nodiscard]] Vector3 PlaceOf(Index vertex) const { return this->Surface->positions().row(vertex).transpose(); }
  [[nodiscard]] bool IsNode(int n) const { return n >= 0 && n < static_cast<int>(this->Internal->Nodes.size()); }
  void ShowSprites();

  std::shared_ptr<const VisibleSurface> Surface;
  double PixelRatio = 1;
  std::vector<Index> Preview;
  vtkNew<SurfacePointPlacer> Placer;
  vtkNew<SurfaceCurveInterpolator> Interpolator;

  vtkNew<vtkPolyData> Line;
  vtkNew<vtkPolyData> PreviewLine;
  vtkNew<BehindActor> LineBehind;
  vtkNew<BlendedActor> LineRim;
  vtkNew<BlendedActor> LineFront;
  vtkNew<BlendedActor> PreviewRim;
  vtkNew<BlendedActor> PreviewFront;
  PointSprites DotsBehind{SpriteShape::Ball, SpriteDepth::Behind};
  PointSprites Dots{SpriteShape::Ball};
  PointSprites PreviewDot{SpriteShape::Hollow};
  PointSprites ActiveRing{SpriteShape::Ring};
  PointSprites ClosingRing{SpriteShape::Ring};
};

/// Draws a closed curve along the edges of a surface. Clicks place vertices, which shortest paths of edges join. A
/// click within 12 pixels of the first vertex closes the curve. Then its places can be dragged, and a drag from
/// elsewhere on it adds one. A click is as `Click` describes.
///
///     vtkNew<SurfaceCurveWidget> curve;
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
class SurfaceCurveWidget : public WidgetOf<SurfaceCurveRepresentation, vtkContourWidget> {
 public:
  static SurfaceCurveWidget* New();
  vtkTypeMacro(SurfaceCurveWidget, vtkContourWidget)

  [[nodiscard]] SurfaceCurveRepresentation* GetSurfaceCurveRepresentation() { return &this->Drawn(); }
  void SetEnabled(int enabling) override;

  /// Sets the surface; with null, the default, there is no curve. Positions may change at any time. A surface of
  /// another model removes the curve.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  /// Sets the regions of the surface's model, whose edges the curve follows. With null, the default, clicks are
  /// refused.
  void SetRegions(std::shared_ptr<const VertexRegions> regions) { this->Drawn().SetRegions(std::move(regions)); }
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }
  [[nodiscard]] double GetPixelRatio() { return this->Drawn().GetPixelRatio(); }

  /// Return what the representation returns: the places, and the places with all vertices between.
  [[nodiscard]] std::vector<Index> GetPlaces() { return this->Drawn().GetPlaces(); }
  [[nodiscard]] std::vector<Index> GetPath() { return this->Drawn().GetPath(); }
  [[nodiscard]] bool IsClosed() { return this->Drawn().GetClosedLoop() != 0; }

  /// Makes an open curve through these vertices instead, without an event. Call it after surface and regions are set.
  /// It returns false, and there is no curve, where a vertex cannot be a place
  /// (`SurfaceCurveRepresentation::InsertPlace`).
  bool SetPlaces(const std::vector<Index>& vertices);
  /// Removes the curve, without an event.
  void Clear();

  // The functions below do what mouse and keys do, with the same events.

  /// Puts a place at the end of an open curve. It returns false where that is not possible.
  bool AddPlace(Index vertex);
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
  SurfaceCurveWidget();
  ~SurfaceCurveWidget() override = default;

  void Stop() override;

 private:
  // There is one for each widget event. It returns whether it has used the VTK event.
  bool Press();
  bool MoveTo();
  bool Release();
  void Leave();
  bool RemoveByHand();

  bool BeginDrag();
  void Hover(const DisplayPoint& cursor);
  void Changed();
  void Tell(unsigned long event);
  void ShowChanges();
  [[nodiscard]] bool IsDragging() { return this->Drawn().GetCurrentOperation() != vtkContourRepresentation::Inactive; }

  std::vector<Index> PlacesBefore;  // as they were before the drag that is under way
};

}  // namespace holdfast
