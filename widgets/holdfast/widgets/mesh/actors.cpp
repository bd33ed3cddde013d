#include "holdfast/widgets/mesh/actors.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

namespace holdfast {

vtkStandardNewMacro(BlendedActor);

void BlendedActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  // Then no depths are written.
  SetIsRenderingTranslucentPolygonalGeometry(true);
  vtkOpenGLActor::Render(renderer, mapper);
  SetIsRenderingTranslucentPolygonalGeometry(false);
}

vtkStandardNewMacro(BehindActor);

void BehindActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  // GL_LEQUAL and GL_GREATER.
  constexpr unsigned int kAsNearOrNearer = 0x0203;
  constexpr unsigned int kFarther = 0x0204;
  vtkOpenGLState* const state = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
  state->vtkglDepthFunc(kFarther);
  BlendedActor::Render(renderer, mapper);
  state->vtkglDepthFunc(kAsNearOrNearer);
}

}  // namespace holdfast
