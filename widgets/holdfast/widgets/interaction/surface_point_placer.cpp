#include "holdfast/widgets/interaction/surface_point_placer.h"

#include <algorithm>
#include <utility>

#include <vtkObjectFactory.h>
#include <vtkRenderer.h>

namespace holdfast {

vtkStandardNewMacro(SurfacePointPlacer);

void SurfacePointPlacer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
  os << indent << "Kind: " << static_cast<int>(this->Kind) << '\n';
  os << indent << "SnapPixels: " << this->SnapPixels << '\n';
  os << indent << "PixelRatio: " << this->PixelRatio << '\n';
}

void SurfacePointPlacer::SetSurface(std::shared_ptr<const VisibleSurface> surface)
{
  if (this->Surface == surface) return;
  this->Surface = std::move(surface);
  this->Modified();
}

void SurfacePointPlacer::SetKind(PickKind kind)
{
  if (this->Kind == kind) return;
  this->Kind = kind;
  this->Modified();
}

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

int SurfacePointPlacer::ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double /*refWorldPos*/[3],
                                             double worldPos[3], double worldOrient[9])
{
  return this->ComputeWorldPosition(renderer, displayPos, worldPos, worldOrient);
}

int SurfacePointPlacer::ValidateWorldPosition(double /*worldPos*/[3])
{
  return 1;
}

int SurfacePointPlacer::ValidateWorldPosition(double /*worldPos*/[3], double /*worldOrient*/[9])
{
  return 1;
}

}  // namespace holdfast
