#include "holdfast/widgets/draw_fence.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include <vtkRenderWindow.h>

namespace holdfast {
namespace {

/// Null where the window has nothing to draw in yet, or no longer.
QOpenGLExtraFunctions* functionsOf(vtkRenderWindow& window)
{
  window.MakeCurrent();
  QOpenGLContext* context = QOpenGLContext::currentContext();
  return context != nullptr ? context->extraFunctions() : nullptr;
}

}  // namespace

DrawFence::DrawFence(vtkRenderWindow& window) : window_(window) {}

DrawFence::~DrawFence()
{
  drop();
}

void DrawFence::set()
{
  drop();
  QOpenGLExtraFunctions* gl = functionsOf(window_);
  if (gl == nullptr) return;
  sync_ = gl->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl->glFlush();
}

void DrawFence::drop()
{
  if (sync_ == nullptr) return;
  if (QOpenGLExtraFunctions* gl = functionsOf(window_)) gl->glDeleteSync(static_cast<GLsync>(sync_));
  sync_ = nullptr;
}

bool DrawFence::pass()
{
  if (sync_ == nullptr) return true;
  QOpenGLExtraFunctions* gl = functionsOf(window_);
  constexpr GLuint64 kDoNotWait = 0;
  if (gl != nullptr && gl->glClientWaitSync(static_cast<GLsync>(sync_), 0, kDoNotWait) == GL_TIMEOUT_EXPIRED)
    return false;
  drop();
  return true;
}

}  // namespace holdfast
