#pragma once
/// A render window of VTK that draws with an OpenGL context of another toolkit.

#include <vtkGenericOpenGLRenderWindow.h>

namespace holdfast {

/// VTK 9.1 to 9.3 find OpenGL by a library that asks for an X server as well, print that there is none, and do not set
/// up their window. The functions of OpenGL are there all the same: on Wayland this window goes on with them.
class ContextWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static ContextWindow* New();
  vtkTypeMacro(ContextWindow, vtkGenericOpenGLRenderWindow)

  void OpenGLInitContext() override;

 protected:
  ContextWindow() = default;
};

}  // namespace holdfast
