#pragma once
/// \file
/// Shortest ways along the edges of a surface, for VTK's contours.

#include <memory>
#include <optional>
#include <vector>

#include <vtkContourLineInterpolator.h>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// Joins nodes of a contour by shortest paths of edges: as long as these are at rest, drawn where the surface is. Nodes
/// are vertices of the file: the `PointId` of each, and of each point between.
class SurfaceCurveInterpolator : public vtkContourLineInterpolator {
 public:
  static SurfaceCurveInterpolator* New();
  vtkTypeMacro(SurfaceCurveInterpolator, vtkContourLineInterpolator)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Until both are there, and made of one model, nothing is joined; null by default.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }
  void SetRegions(std::shared_ptr<const VertexRegions> regions);
  [[nodiscard]] const std::shared_ptr<const VertexRegions>& GetRegions() const { return this->Regions; }

  /// The vertices of a shortest path, both ends included; none where no edges join them. Of vertices that are one
  /// unknown (unwelded files) the first stands for all on the way. Costs what `ShortestPaths::path` does.
  [[nodiscard]] std::vector<Index> DependencyGroup(Index from, Index to);

  /// 1, or 0 where nothing joins the nodes.
  int InterpolateLine(vtkRenderer* renderer, vtkContourRepresentation* contour, int from, int to) override;

 protected:
  SurfaceCurveInterpolator() = default;
  ~SurfaceCurveInterpolator() override = default;

 private:
  SurfaceCurveInterpolator(const SurfaceCurveInterpolator&) = delete;
  void operator=(const SurfaceCurveInterpolator&) = delete;

  std::shared_ptr<const VisibleSurface> Surface;
  std::shared_ptr<const VertexRegions> Regions;
  std::optional<ShortestPaths> Paths;  // in the graph of the regions
};

}  // namespace holdfast
