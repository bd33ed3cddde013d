#include "holdfast/widgets/mesh/blended_actor.h"

#include <vtkObjectFactory.h>

namespace holdfast {

vtkStandardNewMacro(BlendedActor);

BlendedActor::BlendedActor()
{
  ForceOpaqueOn();
}

void BlendedActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  // Then no depths are written.
  SetIsRenderingTranslucentPolygonalGeometry(true);
  vtkOpenGLActor::Render(renderer, mapper);
  SetIsRenderingTranslucentPolygonalGeometry(false);
}

}  // namespace holdfast
