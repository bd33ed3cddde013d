#include "holdfast/widgets/interaction/surface_handle_representation.h"

#include <utility>

#include <vtkObjectFactory.h>
#include <vtkRenderer.h>

#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/interaction/surface_point_placer.h>

namespace holdfast {

vtkStandardNewMacro(SurfaceHandleRepresentation);

void SurfaceHandleRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Placement: " << (this->Placement ? "on the surface" : "(none)") << '\n';
}

const VisibleSurface* SurfaceHandleRepresentation::GetSurface() const
{
  const auto* placer = SurfacePointPlacer::SafeDownCast(this->PointPlacer);
  return placer != nullptr ? placer->GetSurface().get() : nullptr;
}

void SurfaceHandleRepresentation::SetLocation(const SurfaceLocation& location)
{
  if (this->GetSurface() == nullptr) {
    vtkErrorMacro("The placer must have a surface before the handle has a location");
    return;
  }
  const Model& model = this->GetSurface()->model();
  const SurfaceLocator locator = model.locator();
  this->SetPlacement(SurfacePlacement{location, locator.locate(location, {}).point});
}

void SurfaceHandleRepresentation::SetPlacement(std::optional<SurfacePlacement> placement)
{
  this->Placement = std::move(placement);
  this->FollowSurface();
  this->Modified();
}

void SurfaceHandleRepresentation::FollowSurface()
{
  if (!this->Placement) return;
  Vector3 place = this->GetPlace();
  this->SetWorldPosition(place.data());
}

Vector3 SurfaceHandleRepresentation::GetRestPlace() const
{
  return positionOf(this->Placement->point, this->GetSurface()->model().mesh.positions);
}

Vector3 SurfaceHandleRepresentation::GetPlace() const
{
  return positionOf(this->Placement->point, this->GetSurface()->positions());
}

void SurfaceHandleRepresentation::SetDisplayPosition(double display[3])
{
  auto* placer = SurfacePointPlacer::SafeDownCast(this->PointPlacer);
  if (placer == nullptr || this->Renderer == nullptr) return this->Superclass::SetDisplayPosition(display);
  const auto pick = placer->Pick(*this->Renderer, display);
  if (pick)
    this->SetPlacement(SurfacePlacement{pick->location, pointOf(pick->location, this->GetSurface()->model().mesh)});
}

}  // namespace holdfast
