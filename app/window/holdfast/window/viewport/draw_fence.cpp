#include "holdfast/window/viewport/draw_fence.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <utility>

#include <vtkRenderWindow.h>

namespace holdfast {
namespace {

/// Null while the window has no OpenGL context.
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
  drop({&asked_, &held_, &passed_});
}

void DrawFence::set()
{
  drop({&asked_, &held_});
  QOpenGLExtraFunctions* gl = functionsOf(window_);
  if (gl == nullptr) return;
  for (Sync* sync : {&asked_, &held_}) *sync = gl->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl->glFlush();
}

void DrawFence::drop(std::initializer_list<Sync*> syncs)
{
  QOpenGLExtraFunctions* gl = functionsOf(window_);
  for (Sync* sync : syncs) {
    if (gl != nullptr && *sync != nullptr) gl->glDeleteSync(static_cast<GLsync>(*sync));
    *sync = nullptr;
  }
}

bool DrawFence::pass(std::chrono::nanoseconds patience)
{
  if (asked_ == nullptr) return true;
  QOpenGLExtraFunctions* gl = functionsOf(window_);
  const auto time = static_cast<GLuint64>(patience.count());
  if (gl != nullptr && gl->glClientWaitSync(static_cast<GLsync>(asked_), 0, time) == GL_TIMEOUT_EXPIRED) return false;
  drop({&asked_, &passed_});
  passed_ = std::exchange(held_, nullptr);
  return true;
}

}  // namespace holdfast
