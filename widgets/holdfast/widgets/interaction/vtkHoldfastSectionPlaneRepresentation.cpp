#include "holdfast/widgets/interaction/vtkHoldfastSectionPlaneRepresentation.h"

#include <vtkActor.h>

#include <holdfast/widgets/camera/display_transform.h>

using namespace holdfast;

vtkStandardNewMacro(vtkHoldfastSectionPlaneRepresentation);

void vtkHoldfastSectionPlaneRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.get() << '\n';
}

int vtkHoldfastSectionPlaneRepresentation::ComputeInteractionState(int x, int y, int modify)
{
  const auto isOverSurface = [&] {
    const Ray sight = DisplayTransform(*this->Renderer).rayThrough(centerOfPixel(x, y));
    return this->Surface->firstHit(sight).has_value();
  };
  this->CutActor->SetPickable(this->Surface && isOverSurface() ? 0 : 1);
  return this->Superclass::ComputeInteractionState(x, y, modify);
}
