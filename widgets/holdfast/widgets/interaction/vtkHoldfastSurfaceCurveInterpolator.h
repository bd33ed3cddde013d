#pragma once
/// Joins points of VTK's contours along the edges of a surface.

#include <memory>
#include <vector>

#include <vtkContourLineInterpolator.h>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Joins nodes of a contour by shortest paths of edges at rest. The `PointId` of a node, or of a point between nodes,
/// is the vertex.
class vtkHoldfastSurfaceCurveInterpolator : public vtkContourLineInterpolator {
 public:
  static vtkHoldfastSurfaceCurveInterpolator* New();
  vtkTypeMacro(vtkHoldfastSurfaceCurveInterpolator, vtkContourLineInterpolator)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Set the surface and the regions; both are null by default. Nothing is joined until both are set and made of one
  /// model.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface)
  {
    holdfast::assign(*this, this->Surface, std::move(surface));
  }
  [[nodiscard]] const std::shared_ptr<const holdfast::VisibleSurface>& GetSurface() const { return this->Surface; }
  void SetRegions(std::shared_ptr<const holdfast::VertexRegions> regions)
  {
    holdfast::assign(*this, this->Regions, std::move(regions));
  }
  [[nodiscard]] const std::shared_ptr<const holdfast::VertexRegions>& GetRegions() const { return this->Regions; }

  /// Returns the vertices of a shortest path, with both ends. Between the ends it has the first vertex of each unknown.
  /// It is empty where no edges join the two.
  [[nodiscard]] std::vector<holdfast::Index> Path(holdfast::Index from, holdfast::Index to);

  /// Returns 1, or 0 where nothing joins the nodes.
  int InterpolateLine(vtkRenderer* renderer, vtkContourRepresentation* contour, int from, int to) override;

 protected:
  vtkHoldfastSurfaceCurveInterpolator() = default;
  ~vtkHoldfastSurfaceCurveInterpolator() override = default;

 private:
  std::shared_ptr<const holdfast::VisibleSurface> Surface;
  std::shared_ptr<const holdfast::VertexRegions> Regions;
};
