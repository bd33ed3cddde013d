#include "holdfast/window/controls/render_request.h"

#include <QCoreApplication>
#include <QPointer>
#include <QTimer>
#include <deque>
#include <utility>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>

namespace holdfast {
namespace {

/// Those that wait, and a turn of the event loop for each.
class Queue : public QObject {
 public:
  explicit Queue(QObject* parent) : QObject(parent)
  {
    turn_.setSingleShot(true);
    connect(&turn_, &QTimer::timeout, this, &Queue::drawNext);
  }

  static Queue& ofApplication()
  {
    static QPointer<Queue> queue;
    if (!queue) queue = new Queue(QCoreApplication::instance());
    return *queue;
  }

  void add(RenderRequest& request)
  {
    waiting_.emplace_back(&request);
    if (!turn_.isActive()) turn_.start(0);
  }

 private:
  void drawNext()
  {
    const QPointer<RenderRequest> next = waiting_.front();
    waiting_.pop_front();
    if (!waiting_.empty()) turn_.start(0);
    if (next) next->draw();
  }

  std::deque<QPointer<RenderRequest>> waiting_;
  QTimer turn_;
};

}  // namespace

RenderRequest::RenderRequest(QVTKOpenGLNativeWidget& view) : QObject(&view), view_(view)
{
  view.renderWindow()->AddObserver(vtkCommand::EndEvent, this, &RenderRequest::drawn);
}

void RenderRequest::post()
{
  if (isPosted_) return;
  isPosted_ = true;
  Queue::ofApplication().add(*this);
}

void RenderRequest::draw()
{
  if (!std::exchange(isPosted_, false)) return;
  // Before its first frame the view has no OpenGL, and draws of itself.
  if (view_.isVisible() && view_.isValid()) view_.renderWindow()->Render();
}

}  // namespace holdfast
