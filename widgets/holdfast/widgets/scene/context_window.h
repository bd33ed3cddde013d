#pragma once
/// This render window of VTK draws with an OpenGL context of another toolkit.

#include <vtkGenericOpenGLRenderWindow.h>

namespace holdfast {

/// A window that goes on where VTK's own stops. VTK 9.1 to 9.3 find OpenGL by a library that asks for an X server as
/// well. Where there is none, they print so and do not set up their window. The functions of OpenGL are there all the
/// same. On Wayland this window goes on with them.
class ContextWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static ContextWindow* New();
  vtkTypeMacro(ContextWindow, vtkGenericOpenGLRenderWindow)

  void OpenGLInitContext() override;

 protected:
  ContextWindow() = default;
};

}  // namespace holdfast
