#include "holdfast/widgets/interaction/surface_curve_interpolator.h"

#include <utility>

#include <vtkContourRepresentation.h>
#include <vtkObjectFactory.h>

namespace holdfast {

vtkStandardNewMacro(SurfaceCurveInterpolator);

void SurfaceCurveInterpolator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Regions: " << this->Regions.get() << '\n';
}

void SurfaceCurveInterpolator::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  this->Surface = std::move(surface);
  this->Modified();
}

void SurfaceCurveInterpolator::SetRegions(std::shared_ptr<const VertexRegions> regions)
{
  if (this->Regions == regions) return;
  this->Regions = std::move(regions);
  this->Paths.reset();
  if (this->Regions) this->Paths.emplace(this->Regions->graph());
  this->Modified();
}

std::vector<Index> SurfaceCurveInterpolator::DependencyGroup(Index from, Index to)
{
  if (!this->Surface || !this->Paths) return {};
  const Weld& weld = this->Surface->model().solverMesh.weld;
  std::vector<Index> path = this->Paths->path(weld.unknownOf[from], weld.unknownOf[to]);
  if (path.empty()) return path;
  for (Index& unknown : path) unknown = weld.firstVertexOf[unknown];
  path.front() = from;
  path.back() = to;
  return path;
}

int SurfaceCurveInterpolator::InterpolateLine(vtkRenderer* /*renderer*/, vtkContourRepresentation* contour, int from,
                                              int to)
{
  const std::vector<Index> path =
      this->DependencyGroup(Index{contour->GetNthNode(from)->PointId}, Index{contour->GetNthNode(to)->PointId});
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    Vector3 place = this->Surface->positions().row(path[k]).transpose();
    contour->AddIntermediatePointWorldPosition(from, place.data(), path[k]);
  }
  return path.empty() ? 0 : 1;
}

}  // namespace holdfast
