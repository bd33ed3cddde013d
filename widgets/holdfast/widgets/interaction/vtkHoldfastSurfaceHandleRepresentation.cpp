#include "holdfast/widgets/interaction/vtkHoldfastSurfaceHandleRepresentation.h"

#include <utility>

#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSurfaceHandleRepresentation);

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
  if (this->GetSurface() != nullptr)
    this->SetPlacement(this->PlacementAt(location));
  else
    vtkErrorMacro("The placer must have a surface before the handle has a location");
}

void vtkHoldfastSurfaceHandleRepresentation::SetPlacement(std::optional<SurfacePlacement> placement)
{
  this->Placement = std::move(placement);
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
  const auto pick = placer->Pick(*this->Renderer, display);
  if (pick)
    this->SetPlacement(SurfacePlacement{pick->location, pointOf(pick->location, this->GetSurface()->model().mesh)});
}
