#include "holdfast/window/viewport/repaint_pause.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace holdfast {

void RepaintPause::begin()
{
  end();
  window_ = inside_.window();
  window_->installEventFilter(this);
}

bool RepaintPause::end()
{
  if (!window_) return false;
  window_->removeEventFilter(this);
  const bool wasWaiting = std::exchange(isWaiting_, false);
  if (wasWaiting) QCoreApplication::postEvent(window_, new QEvent(QEvent::UpdateRequest), Qt::LowEventPriority);
  window_.clear();
  return wasWaiting;
}

bool RepaintPause::eventFilter(QObject* watched, QEvent* event)
{
  if (watched != window_ || event->type() != QEvent::UpdateRequest) return QObject::eventFilter(watched, event);
  isWaiting_ = true;
  return true;
}

}  // namespace holdfast
