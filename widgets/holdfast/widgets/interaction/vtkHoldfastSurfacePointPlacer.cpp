#include "holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h"

#include <algorithm>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfacePointPlacer);

std::optional<SurfacePick> vtkHoldfastSurfacePointPlacer::Pick(vtkRenderer& renderer, const double displayPos[2]) const
{
  if (!this->Surface) return std::nullopt;
  return SurfacePicker(this->Surface)
      .pick(renderer, displayPos[0], displayPos[1], this->Kind, this->SnapPixels * this->PixelRatio);
}

int vtkHoldfastSurfacePointPlacer::ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double worldPos[3],
                                                        double worldOrient[9])
{
  const auto pick = this->Pick(*renderer, displayPos);
  if (!pick) return 0;
  this->LastPick = pick;
  std::copy_n(pick->place.data(), 3, worldPos);
  for (int k = 0; k < 9; ++k) worldOrient[k] = k % 4 == 0 ? 1 : 0;
  return 1;
}
