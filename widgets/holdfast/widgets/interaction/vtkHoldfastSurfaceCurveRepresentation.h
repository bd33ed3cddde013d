#pragma once
/// Draws a contour along the edges of a surface.

#include <memory>
#include <utility>
#include <vector>

#include <vtkContourRepresentation.h>
#include <vtkNew.h>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCurveInterpolator.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h>
#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/actors.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Draws a contour along the edges of a surface. Its nodes, the places, are different vertices of one connected part of
/// the surface.
class vtkHoldfastSurfaceCurveRepresentation : public holdfast::DrawnByProps<vtkContourRepresentation> {
 public:
  static vtkHoldfastSurfaceCurveRepresentation* New();
  vtkTypeMacro(vtkHoldfastSurfaceCurveRepresentation, vtkContourRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the surface; with null, the default, there is no curve. A surface of another model removes the curve.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface);
  /// Sets the regions, made of the surface's model, whose edges the curve follows. With null, the default, places are
  /// refused.
  void SetRegions(std::shared_ptr<const holdfast::VertexRegions> regions)
  {
    this->Interpolator->SetRegions(std::move(regions));
  }

  void SetPixelRatio(double ratio);
  vtkGetMacro(PixelRatio, double);

  /// Return vertices of the file in order. `GetPlaces` returns the places alone, `GetPath` the places with all vertices
  /// between. For a closed curve the path includes the vertices from the last place to the first.
  [[nodiscard]] std::vector<holdfast::Index> GetPlaces() const;
  [[nodiscard]] std::vector<holdfast::Index> GetPath() const;

  /// `InsertPlace` inserts a place before the `n`-th one, `MovePlace` moves that one. Both return false, and change
  /// nothing, for a vertex that the mesh does not have, as -1, and for three kinds of vertices. These are a vertex that
  /// no face uses, one that is a place already, and one to which no edges lead from the others.
  bool InsertPlace(int n, holdfast::Index vertex);
  bool MovePlace(int n, holdfast::Index vertex);

  /// Returns the vertex for a click on a pixel. `SurfacePicker` finds it within 12 pixels. Beside the surface it
  /// returns -1.
  [[nodiscard]] holdfast::Index VertexAt(const holdfast::DisplayPoint& pixel) const;
  /// Tells whether a click on the pixel closes the curve. It does where the first of three places or more is within 12
  /// pixels.
  [[nodiscard]] bool IsAtFirst(const holdfast::DisplayPoint& pixel);
  [[nodiscard]] bool IsClosable() const;

  /// Shows the path from the last place to a vertex. Where there is no place yet, it shows that vertex alone. With -1
  /// it shows nothing.
  void SetPreview(holdfast::Index vertex);
  void HidePreview() { this->SetPreview(-1); }
  [[nodiscard]] const std::vector<holdfast::Index>& GetPreview() const { return this->Preview; }

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
    return this->InsertPlace(this->GetNumberOfNodes(), this->VertexAt(holdfast::DisplayPoint(pixel)));
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
    return this->MovePlace(n, this->VertexAt(holdfast::DisplayPoint(pixel)));
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
  vtkHoldfastSurfaceCurveRepresentation();
  ~vtkHoldfastSurfaceCurveRepresentation() override = default;

  void BuildLines() override { this->Modified(); }
  void InitializeContour(vtkPolyData* line, vtkIdList* vertices) override;

 private:
  [[nodiscard]] bool IsPossible(holdfast::Index vertex, int moved) const;
  [[nodiscard]] holdfast::Index NearestVertex(const double place[3]) const;
  [[nodiscard]] holdfast::Vector3 PlaceOf(holdfast::Index vertex) const
  {
    return this->Surface->positions().row(vertex).transpose();
  }
  [[nodiscard]] bool IsNode(int n) const { return n >= 0 && n < static_cast<int>(this->Internal->Nodes.size()); }
  void ShowSprites();

  std::shared_ptr<const holdfast::VisibleSurface> Surface;
  double PixelRatio = 1;
  std::vector<holdfast::Index> Preview;
  vtkNew<vtkHoldfastSurfacePointPlacer> Placer;
  vtkNew<vtkHoldfastSurfaceCurveInterpolator> Interpolator;

  vtkNew<vtkPolyData> Line;
  vtkNew<vtkPolyData> PreviewLine;
  vtkNew<holdfast::BehindActor> LineBehind;
  vtkNew<holdfast::BlendedActor> LineRim;
  vtkNew<holdfast::BlendedActor> LineFront;
  vtkNew<holdfast::BlendedActor> PreviewRim;
  vtkNew<holdfast::BlendedActor> PreviewFront;
  holdfast::PointSprites DotsBehind{holdfast::SpriteShape::Ball, holdfast::SpriteDepth::Behind};
  holdfast::PointSprites Dots{holdfast::SpriteShape::Ball};
  holdfast::PointSprites PreviewDot{holdfast::SpriteShape::Hollow};
  holdfast::PointSprites ActiveRing{holdfast::SpriteShape::Ring};
  holdfast::PointSprites ClosingRing{holdfast::SpriteShape::Ring};
};
