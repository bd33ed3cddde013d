#include "holdfast/widgets/scene/context_window.h"

#include <vtkObjectFactory.h>
#include <vtk_glew.h>

namespace holdfast {
namespace {

/// Tells whether the functions of OpenGL are there, and only those of X are not.
bool lacksOnlyX()
{
#ifdef GLEW_ERROR_NO_GLX_DISPLAY
  return glewInit() == GLEW_ERROR_NO_GLX_DISPLAY && GLEW_VERSION_3_1;
#else
  return false;
#endif
}

}  // namespace

vtkStandardNewMacro(ContextWindow);

void ContextWindow::OpenGLInitContext()
{
  if (this->Initialized || !lacksOnlyX()) return Superclass::OpenGLInitContext();
  this->ContextCreationTime.Modified();
  this->GlewInitValid = true;
  this->Initialized = true;
  float widths[2] = {1, 1};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
  this->MaximumHardwareLineWidth = widths[1];
}

}  // namespace holdfast
