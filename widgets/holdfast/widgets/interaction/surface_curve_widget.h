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

/// A contour whose nodes, the places, are different vertices of one connected part of the surface.
class SurfaceCurveRepresentation : public DrawnByProps<vtkContourRepresentation> {
 public:
  static SurfaceCurveRepresentation* New();
  vtkTypeMacro(SurfaceCurveRepresentation, vtkContourRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Null (the default): no curve. A surface of another model removes the curve.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  /// Made of the surface's model, whose edges the curve follows; null (the default): places are refused.
  void SetRegions(std::shared_ptr<const VertexRegions> regions) { this->Interpolator->SetRegions(std::move(regions)); }

  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  /// Vertices of the file, in order: the places; the places with all vertices between, for a closed curve also those
  /// from the last place to the first.
  [[nodiscard]] std::vector<Index> GetPlaces() const;
  [[nodiscard]] std::vector<Index> GetPath() const;

  /// Inserts a place before the `n`-th one, or moves that one. False, and no change, for a vertex that no face uses,
  /// that is a place already, or to which no edges lead from the others.
  bool InsertPlace(int n, std::optional<Index> vertex);
  bool MovePlace(int n, std::optional<Index> vertex);

  /// The vertex for a click on a pixel, found by `SurfacePicker` within 12 pixels; none beside the surface.
  [[nodiscard]] std::optional<Index> VertexAt(const DisplayPoint& pixel) const;
  /// Whether a click there closes the curve: the first of three places or more is within 12 pixels.
  [[nodiscard]] bool IsAtFirst(const DisplayPoint& pixel);
  [[nodiscard]] bool IsClosable() const;

  /// Shows the path from the last place to a vertex, or that vertex alone.
  void SetPreview(std::optional<Index> vertex);
  [[nodiscard]] const std::vector<Index>& GetPreview() const { return this->Preview; }

  // VTK's functions for nodes. A place in space means the nearest vertex, O(N).
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
  /// The nearest visible place within 12 pixels.
  int ActivateNode(double pixel[2]) override;
  void ClearAllNodes() override;

  void BuildRepresentation() override;
  int ComputeInteractionState(int x, int y, int modified = 0) override;
  void StartWidgetInteraction(double /*pixel*/[2]) override {}
  /// Takes the active place, while it is translated, to the vertex under the cursor.
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

/// Clicks place vertices that shortest paths of edges join. A click within 12 pixels of the first one closes the curve;
/// then its places can be dragged, and a drag from elsewhere on it adds one. Clicks are as in `Click`.
///
/// `FollowCursor`, on by default, shows the way to the vertex under the cursor; `ContinuousDraw` and
/// `AllowNodePicking` are without effect. `CloseLoop` closes without an event. Disabling keeps the curve.
class SurfaceCurveWidget : public WidgetOf<SurfaceCurveRepresentation, vtkContourWidget> {
 public:
  static SurfaceCurveWidget* New();
  vtkTypeMacro(SurfaceCurveWidget, vtkContourWidget)

  [[nodiscard]] SurfaceCurveRepresentation* GetSurfaceCurveRepresentation() { return &this->Drawn(); }
  void SetEnabled(int enabling) override;

  /// Null (the default): no curve. Positions may change at any time; a surface of another model removes the curve.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  /// Those of the surface's model; null (the default): clicks are refused.
  void SetRegions(std::shared_ptr<const VertexRegions> regions) { this->Drawn().SetRegions(std::move(regions)); }
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }
  [[nodiscard]] double GetPixelRatio() { return this->Drawn().GetPixelRatio(); }

  /// As of the representation: the vertices that were clicked, and those with all between.
  [[nodiscard]] std::vector<Index> GetPlaces() { return this->Drawn().GetPlaces(); }
  [[nodiscard]] std::vector<Index> GetPath() { return this->Drawn().GetPath(); }
  [[nodiscard]] bool IsClosed() { return this->Drawn().GetClosedLoop() != 0; }

  /// An open curve through these vertices instead, without an event. Surface and regions are set. False, and no curve,
  /// where one cannot be a place (`SurfaceCurveRepresentation::InsertPlace`).
  bool SetPlaces(const std::vector<Index>& vertices);
  /// No curve, without an event.
  void Clear();

  // As mouse and keys, with the same events.

  /// Puts a place at the end of an open curve. False where that is not possible.
  bool AddPlace(Index vertex);
  /// False for a closed curve, and for fewer than three places.
  bool Close();
  /// Takes the last place back; the curve is open then. False where there is none.
  bool RemoveLast();
  /// Takes a drag back, or else all places. False where there are none.
  bool Cancel();

  /// As VTK's, from points near vertices or, better, from vertices. An open line can be continued.
  void Initialize(vtkPolyData* line, int state = 1, vtkIdList* vertices = nullptr) override;
  using vtkContourWidget::Initialize;

 protected:
  SurfaceCurveWidget();
  ~SurfaceCurveWidget() override = default;

  void Stop() override;

 private:
  // One for each widget event: whether the VTK event has been used.
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

  std::vector<Index> PlacesBefore;  // the drag that is under way
};

}  // namespace holdfast
