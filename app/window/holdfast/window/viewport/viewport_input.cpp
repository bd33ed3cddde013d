// How Qt's events reach VTK's interactor, and which keys Qt handles.

#include <QKeyEvent>
#include <QMouseEvent>
#include <utility>

#include <holdfast/window/viewport/viewport.h>
#include <holdfast/window/viewport/viewport_overlay.h>

namespace holdfast {

void Viewport::setTool(Tool* tool)
{
  if (tool_ == tool) return;
  cancelGesture();
  if (tool_) {
    tool_->end();
    disconnect(tool_, nullptr, overlay_, nullptr);
  }
  tool_ = tool;
  if (tool_) {
    tool_->begin();
    connect(tool_, &Tool::paintChanged, overlay_, qOverload<const QRect&>(&QWidget::update));
  }
  // Widgets that show another cursor return to this one.
  setDefaultCursor(tool_ ? tool_->cursor() : Qt::ArrowCursor);
  setCursor(defaultCursor());
  overlay_->setTools({tool_, firstTool_});
}

void Viewport::setFirstTool(Tool* tool)
{
  firstTool_ = tool;
  connect(tool, &Tool::paintChanged, overlay_, qOverload<const QRect&>(&QWidget::update));
  overlay_->setTools({tool_, firstTool_});
}

void Viewport::leaveTool()
{
  if (tool_) tool_->leave();
}

bool Viewport::cancelGesture()
{
  // Gestures of the camera stop where they are.
  style_->Cancel();
  isHeld_ = false;
  return (firstTool_ && firstTool_->cancel()) || (tool_ && tool_->cancel());
}

QPointF Viewport::toPlace(const DisplayPoint& display) const
{
  return {display.x() / pixelRatio(), height() - display.y() / pixelRatio()};
}

bool Viewport::event(QEvent* event)
{
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
      if (!isHeld_) wakeOrientation(static_cast<const QMouseEvent&>(*event).localPos());
      if (event->type() == QEvent::MouseButtonPress) isNewView_ = true;
      isHeld_ = static_cast<const QMouseEvent&>(*event).buttons() != Qt::NoButton;
      // A coarse picture is drawn in full when the mouse rests.
      if (!isHeld_ && isCoarse_) restTimer_.start();
      break;
    case QEvent::Wheel:
      if (!wheel_.isValid() || wheel_.elapsed() > restTimer_.interval()) isNewView_ = true;
      wheel_.start();
      break;
    case QEvent::ShortcutOverride:
      for (const Tool* tool : {firstTool_, tool_}) {
        if (!tool || !tool->wants(static_cast<const QKeyEvent&>(*event))) continue;
        event->accept();
        return true;
      }
      break;
    case QEvent::FocusOut:
      for (Tool* tool : {firstTool_, tool_})
        if (tool) tool->loseFocus();
      break;
    case QEvent::ContextMenu:
      // It comes with the press; the camera's style asks for the menu at the release.
      return true;
    default:
      break;
  }
  return VtkView::event(event);
}

void Viewport::wakeOrientation(const QPointF& place)
{
  const QPointF pixel = pixelRatio() * QPointF(place.x(), height() - place.y());
  const bool isOver =
      orientation_->GetDefaultRenderer()->IsInViewport(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())) != 0;
  // It asks for a picture at every move that it gets. Moves elsewhere are kept from it, but for the first one.
  const bool wasOver = std::exchange(isOverOrientation_, isOver);
  orientation_->SetProcessEvents(isOver || wasOver ? 1 : 0);
}

void Viewport::askForContextMenu()
{
  const int* place = interactor()->GetEventPosition();
  if (contents_) Q_EMIT contextMenuWanted(toPlace({place[0], place[1]}).toPoint());
}

}  // namespace holdfast
