#include "holdfast/widgets/interaction/surface_point_placer.h"

#include <algorithm>

#include <vtkContourRepresentation.h>

namespace holdfast {

vtkStandardNewMacro(SurfacePointPlacer);

std::optional<SurfacePick> SurfacePointPlacer::Pick(vtkRenderer& renderer, const double displayPos[2]) const
{
  if (!this->Surface) return std::nullopt;
  return SurfacePicker(this->Surface)
      .pick(renderer, displayPos[0], displayPos[1], this->Kind, this->SnapPixels * this->PixelRatio);
}

int SurfacePointPlacer::ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double worldPos[3],
                                             double worldOrient[9])
{
  const auto pick = this->Pick(*renderer, displayPos);
  if (!pick) return 0;
  this->LastPick = pick;
  std::copy_n(pick->place.data(), 3, worldPos);
  for (int k = 0; k < 9; ++k) worldOrient[k] = k % 4 == 0 ? 1 : 0;
  return 1;
}

vtkStandardNewMacro(SurfaceCurveInterpolator);

std::vector<Index> SurfaceCurveInterpolator::Path(Index from, Index to)
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

int SurfaceCurveInterpolator::InterpolateLine(vtkRenderer* /*renderer*/, vtkContourRepresentation* contour, int from,
                                              int to)
{
  const std::vector<Index> path =
      this->Path(Index{contour->GetNthNode(from)->PointId}, Index{contour->GetNthNode(to)->PointId});
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    Vector3 place = this->Surface->positions().row(path[k]).transpose();
    contour->AddIntermediatePointWorldPosition(from, place.data(), path[k]);
  }
  return path.empty() ? 0 : 1;
}

}  // namespace holdfast
