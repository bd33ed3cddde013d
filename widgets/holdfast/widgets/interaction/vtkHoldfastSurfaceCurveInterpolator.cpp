#include "holdfast/widgets/interaction/vtkHoldfastSurfaceCurveInterpolator.h"

#include <vtkContourRepresentation.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfaceCurveInterpolator);

void vtkHoldfastSurfaceCurveInterpolator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Regions: " << this->Regions.get() << '\n';
}

std::vector<Index> vtkHoldfastSurfaceCurveInterpolator::Path(Index from, Index to)
{
  if (!this->Surface || !this->Regions) return {};
  const Weld& weld = this->Surface->model().solverMesh.weld;
  std::vector<Index> path = shortestPath(this->Regions->graph(), weld.unknownOf[from], weld.unknownOf[to]);
  if (path.empty()) return path;
  for (Index& unknown : path) unknown = weld.firstVertexOf[unknown];
  path.front() = from;
  path.back() = to;
  return path;
}

int vtkHoldfastSurfaceCurveInterpolator::InterpolateLine(vtkRenderer* /*renderer*/, vtkContourRepresentation* contour,
                                                         int from, int to)
{
  const std::vector<Index> path =
      this->Path(Index{contour->GetNthNode(from)->PointId}, Index{contour->GetNthNode(to)->PointId});
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    Vector3 place = this->Surface->positions().row(path[k]).transpose();
    contour->AddIntermediatePointWorldPosition(from, place.data(), path[k]);
  }
  return path.empty() ? 0 : 1;
}
