#pragma once
/// A surface for VTK's handles and contours: the surface decides where a point is placed, and which line joins two
/// points.

#include <memory>
#include <optional>
#include <vector>

#include <vtkContourLineInterpolator.h>
#include <vtkPointPlacer.h>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// Places points of VTK's handles and contours on a surface. The points are visible and in double precision. They have
/// the weights that a constraint there would have.
///
///     vtkNew<SurfacePointPlacer> placer;
///     placer->SetSurface(surface);
///     vtkNew<vtkPointHandleRepresentation3D> drawn;
///     drawn->SetPointPlacer(placer);
///     handle->SetRepresentation(drawn);  // a vtkHandleWidget
class SurfacePointPlacer : public vtkPointPlacer {
 public:
  static SurfacePointPlacer* New();
  vtkTypeMacro(SurfacePointPlacer, vtkPointPlacer)

  /// Sets the surface; with null, the default, there are no points. It may change at any time.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { assign(*this, this->Surface, std::move(surface)); }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Sets what points may lie on; `Nearest` by default.
  vtkSetEnumMacro(Kind, PickKind);
  [[nodiscard]] PickKind GetKind() const { return this->Kind; }

  /// Sets how near to the cursor a vertex or an edge is taken, in pixels of a display of ordinary resolution. The
  /// default is 7.
  vtkSetClampMacro(SnapPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SnapPixels, double);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// Returns the point that a click on a pixel of the renderer's window means, as `SurfacePicker::pick` does.
  [[nodiscard]] std::optional<SurfacePick> Pick(vtkRenderer& renderer, const double displayPos[2]) const;

  /// Returns the last point that one of the functions below has placed; none before the first.
  [[nodiscard]] const std::optional<SurfacePick>& GetLastPick() const { return this->LastPick; }

  /// Writes the place of the point on the surface and returns 1, or returns 0 where there is no point. The orientation
  /// is the identity.
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double worldPos[3],
                           double worldOrient[9]) override;
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double* /*refWorldPos*/, double worldPos[3],
                           double worldOrient[9]) override
  {
    return this->ComputeWorldPosition(renderer, displayPos, worldPos, worldOrient);
  }
  /// Returns 1: what was placed once stays valid when the surface has moved on.
  int ValidateWorldPosition(double* /*worldPos*/) override { return 1; }
  int ValidateWorldPosition(double* /*worldPos*/, double* /*worldOrient*/) override { return 1; }

 protected:
  SurfacePointPlacer() = default;
  ~SurfacePointPlacer() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
  PickKind Kind = PickKind::Nearest;
  double SnapPixels = 7;
  double PixelRatio = 1;
  std::optional<SurfacePick> LastPick;
};

/// Joins nodes of a contour by shortest paths of edges at rest. The `PointId` of a node, or of a point between nodes,
/// is the vertex.
class SurfaceCurveInterpolator : public vtkContourLineInterpolator {
 public:
  static SurfaceCurveInterpolator* New();
  vtkTypeMacro(SurfaceCurveInterpolator, vtkContourLineInterpolator)

  /// Set the surface and the regions; both are null by default. Nothing is joined until both are set and made of one
  /// model.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { assign(*this, this->Surface, std::move(surface)); }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }
  void SetRegions(std::shared_ptr<const VertexRegions> regions) { assign(*this, this->Regions, std::move(regions)); }
  [[nodiscard]] const std::shared_ptr<const VertexRegions>& GetRegions() const { return this->Regions; }

  /// Returns the vertices of a shortest path, with both ends. Between the ends it has the first vertex of each unknown.
  /// It is empty where no edges join the two.
  [[nodiscard]] std::vector<Index> Path(Index from, Index to);

  /// Returns 1, or 0 where nothing joins the nodes.
  int InterpolateLine(vtkRenderer* renderer, vtkContourRepresentation* contour, int from, int to) override;

 protected:
  SurfaceCurveInterpolator() = default;
  ~SurfaceCurveInterpolator() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
  std::shared_ptr<const VertexRegions> Regions;
};

}  // namespace holdfast
