#include "holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h"

#include <algorithm>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfacePointPlacer);

void vtkHoldfastSurfacePointPlacer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Kind: " << static_cast<int>(this->Kind) << '\n';
  os << indent << "SnapPixels: " << this->SnapPixels << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

bool vtkHoldfastSurfacePointPlacer::Pick(vtkRenderer& renderer, const double displayPos[2], SurfacePick& pick) const
{
  if (!this->Surface) return false;
  const auto found = SurfacePicker(this->Surface)
                         .pick(renderer, displayPos[0], displayPos[1], this->Kind, this->SnapPixels * this->PixelRatio);
  if (found) pick = *found;
  return found.has_value();
}

int vtkHoldfastSurfacePointPlacer::ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double worldPos[3],
                                                        double worldOrient[9])
{
  SurfacePick pick;
  if (!this->Pick(*renderer, displayPos, pick)) return 0;
  this->LastPick = pick;
  std::copy_n(pick.place.data(), 3, worldPos);
  for (int k = 0; k < 9; ++k) worldOrient[k] = k % 4 == 0 ? 1 : 0;
  return 1;
}
