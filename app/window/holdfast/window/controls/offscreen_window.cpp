#include "holdfast/window/controls/offscreen_window.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <vtkObjectFactory.h>

#include <holdfast/widgets/scene/context_window.h>

namespace holdfast {
namespace {

class OffscreenWindow : public ContextWindow {
 public:
  static OffscreenWindow* New();
  vtkTypeMacro(OffscreenWindow, ContextWindow)

  void MakeCurrent() override { context_.makeCurrent(&surface_); }
  bool IsCurrent() override { return QOpenGLContext::currentContext() == &context_; }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void Initialize() override
  {
    MakeCurrent();
    OpenGLInit();
  }

 protected:
  OffscreenWindow()
  {
    surface_.create();
    context_.create();
  }
  ~OffscreenWindow() override
  {
    MakeCurrent();
    Finalize();
    context_.doneCurrent();
  }

 private:
  QOffscreenSurface surface_;
  QOpenGLContext context_;
};

vtkStandardNewMacro(OffscreenWindow);

}  // namespace

vtkSmartPointer<vtkRenderWindow> newOffscreenWindow()
{
  if (QGuiApplication::platformName() == "xcb") return nullptr;
  return vtkSmartPointer<OffscreenWindow>::New();
}

}  // namespace holdfast
