#include "holdfast/widgets/render_request.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderWindow.h>

namespace holdfast {

RenderRequest::RenderRequest(QVTKOpenGLNativeWidget& view) : QObject(&view), view_(view) {}

void RenderRequest::post()
{
  if (isPosted_) return;
  isPosted_ = true;
  QMetaObject::invokeMethod(
      this, [this] { draw(); }, Qt::QueuedConnection);
}

void RenderRequest::draw()
{
  isPosted_ = false;
  // Before its first frame the view has no OpenGL, and draws of itself.
  if (view_.isVisible() && view_.isValid()) view_.renderWindow()->Render();
}

}  // namespace holdfast
