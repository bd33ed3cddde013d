#include "holdfast/widgets/interaction/vtkHoldfastSurfaceHandleRepresentation.h"

#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfaceHandleRepresentation);

void vtkHoldfastSurfaceHandleRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Placed: " << this->Placement.has_value() << '\n';
}

const VisibleSurface* vtkHoldfastSurfaceHandleRepresentation::GetSurface() const
{
  const auto* placer = vtkHoldfastSurfacePointPlacer::SafeDownCast(this->PointPlacer);
  return placer != nullptr ? placer->GetSurface().get() : nullptr;
}

SurfacePlacement vtkHoldfastSurfaceHandleRepresentation::PlacementAt(const SurfaceLocation& location) const
{
  const SurfaceLocator locator = this->GetSurface()->model().locator();
  return {location, locator.locate(location, {})};
}

void vtkHoldfastSurfaceHandleRepresentation::SetLocation(const SurfaceLocation& location)
{
  if (this->GetSurface() == nullptr) {
    vtkErrorMacro("The placer must have a surface before the handle has a location");
    return;
  }
  const SurfacePlacement placement = this->PlacementAt(location);
  this->SetPlacement(&placement);
}

void vtkHoldfastSurfaceHandleRepresentation::SetPlacement(const SurfacePlacement* placement)
{
  this->Placement = placement != nullptr ? std::optional(*placement) : std::nullopt;
  this->FollowSurface();
  this->Modified();
}

void vtkHoldfastSurfaceHandleRepresentation::FollowSurface()
{
  if (!this->Placement) return;
  Vector3 place = this->GetPlace();
  this->SetWorldPosition(place.data());
}

void vtkHoldfastSurfaceHandleRepresentation::SetDisplayPosition(double display[3])
{
  auto* placer = vtkHoldfastSurfacePointPlacer::SafeDownCast(this->PointPlacer);
  if (placer == nullptr || this->Renderer == nullptr) return this->Superclass::SetDisplayPosition(display);
  SurfacePick pick;
  if (!placer->Pick(*this->Renderer, display, pick)) return;
  const SurfacePlacement placement{pick.location, pointOf(pick.location, this->GetSurface()->model().mesh)};
  this->SetPlacement(&placement);
}
