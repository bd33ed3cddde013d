#pragma once
/// A surface for VTK's handles and contours: where a point is placed, and which line joins two of them.

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

/// Its points are visible, in double precision, and have the weights that a constraint there would have.
class SurfacePointPlacer : public vtkPointPlacer {
 public:
  static SurfacePointPlacer* New();
  vtkTypeMacro(SurfacePointPlacer, vtkPointPlacer)

  /// Null (the default): no points. May change at any time.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { assign(*this, this->Surface, std::move(surface)); }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// `Nearest` by default.
  vtkSetEnumMacro(Kind, PickKind);
  [[nodiscard]] PickKind GetKind() const { return this->Kind; }

  /// How near the cursor a vertex or an edge is taken, pixels of a display of ordinary resolution; 7 by default.
  vtkSetClampMacro(SnapPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SnapPixels, double);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// The point that a click on a pixel of the renderer's window means, as `SurfacePicker::pick`.
  [[nodiscard]] std::optional<SurfacePick> Pick(vtkRenderer& renderer, const double displayPos[2]) const;

  /// The last point that one of the functions below has placed; none before the first.
  [[nodiscard]] const std::optional<SurfacePick>& GetLastPick() const { return this->LastPick; }

  /// 1 and the place of the point on the surface, or 0. The orientation is the identity.
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double worldPos[3],
                           double worldOrient[9]) override;
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double* /*refWorldPos*/, double worldPos[3],
                           double worldOrient[9]) override
  {
    return this->ComputeWorldPosition(renderer, displayPos, worldPos, worldOrient);
  }
  /// 1: what was placed once stays valid when the surface has moved on.
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

/// Joins nodes of a contour by shortest paths of edges at rest. `PointId` of nodes and of points between is the vertex.
class SurfaceCurveInterpolator : public vtkContourLineInterpolator {
 public:
  static SurfaceCurveInterpolator* New();
  vtkTypeMacro(SurfaceCurveInterpolator, vtkContourLineInterpolator)

  /// Until both are there, and made of one model, nothing is joined; null by default.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { assign(*this, this->Surface, std::move(surface)); }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }
  void SetRegions(std::shared_ptr<const VertexRegions> regions) { assign(*this, this->Regions, std::move(regions)); }
  [[nodiscard]] const std::shared_ptr<const VertexRegions>& GetRegions() const { return this->Regions; }

  /// The vertices of a shortest path with both ends, between them the first of each unknown; none where no edges join.
  [[nodiscard]] std::vector<Index> Path(Index from, Index to);

  /// 1, or 0 where nothing joins the nodes.
  int InterpolateLine(vtkRenderer* renderer, vtkContourRepresentation* contour, int from, int to) override;

 protected:
  SurfaceCurveInterpolator() = default;
  ~SurfaceCurveInterpolator() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
  std::shared_ptr<const VertexRegions> Regions;
};

}  // namespace holdfast
