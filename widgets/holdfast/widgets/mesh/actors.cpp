#include "holdfast/widgets/mesh/actors.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

namespace holdfast {

vtkStandardNewMacro(BlendedActor);

void BlendedActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  // Then no depths are written.
  SetIsRenderingTranslucentPolygonalGeometry(true);
  vtkOpenGLActor::Render(renderer, mapper);
  SetIsRenderingTranslucentPolygonalGeometry(false);
}

vtkStandardNewMacro(PushedActor);

void PushedActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  // The centre of a pixel of a line is up to one pixel from the line. The steps are of a buffer of 32 bits, where so
  // many are as much as single precision rounds, or of one of 24 bits, where they are still too few to be seen.
  constexpr float kPixels = 1.5F;
  constexpr float kSteps = 1024;
  const auto push = static_cast<float>(push_);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(push * kPixels, push * kSteps);
  vtkOpenGLActor::Render(renderer, mapper);
  glDisable(GL_POLYGON_OFFSET_FILL);
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
