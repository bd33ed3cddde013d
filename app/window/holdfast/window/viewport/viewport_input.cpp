// How Qt's events reach VTK's interactor, and which keys Qt handles.

#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>
#include <utility>

#include <holdfast/window/viewport/viewport.h>
#include <holdfast/window/viewport/viewport_overlay.h>

namespace holdfast {
namespace {

// How near the cursor a vertex or an edge is taken, of a display of ordinary resolution.
constexpr double kCursorPixels = 7;

}  // namespace

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
  frames_->noteCancelled();
  return (firstTool_ && firstTool_->cancel()) || (tool_ && tool_->cancel());
}

QPointF Viewport::toPlace(const DisplayPoint& display) const
{
  return {display.x() / pixelRatio(), height() - display.y() / pixelRatio()};
}

/// A press of the left button on the legend, what follows it until that button is up again, and the free cursor there.
/// Other buttons move the camera there as well.
bool Viewport::isForLegend(const QEvent& event)
{
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      if (const auto& press = static_cast<const QMouseEvent&>(event); press.button() == Qt::LeftButton)
        isLegendPressed_ = press.buttons() == Qt::LeftButton && legendBox().contains(press.localPos());
      return isLegendPressed_;
    case QEvent::MouseButtonRelease:
      if (static_cast<const QMouseEvent&>(event).button() != Qt::LeftButton) return isLegendPressed_;
      return std::exchange(isLegendPressed_, false);
    case QEvent::MouseMove: {
      const auto& move = static_cast<const QMouseEvent&>(event);
      return isLegendPressed_ || (move.buttons() == Qt::NoButton && legendBox().contains(move.localPos()));
    }
    default:
      return false;
  }
}

void Viewport::leavePicture()
{
  interactor()->InvokeEvent(vtkCommand::LeaveEvent);
  lookUnderCursor(nullptr);
}

bool Viewport::event(QEvent* event)
{
  if (isForLegend(*event)) {
    if (event->type() == QEvent::MouseMove) leavePicture();
    if (event->type() == QEvent::MouseButtonDblClick) Q_EMIT legendDoubleClicked();
    return true;
  }
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
      if (!frames_->isHeld()) wakeOrientation(static_cast<const QMouseEvent&>(*event).localPos());
      if (event->type() == QEvent::MouseButtonPress) isNewView_ = true;
      frames_->noteMouse(static_cast<const QMouseEvent&>(*event).buttons() != Qt::NoButton,
                         event->type() == QEvent::MouseMove);
      break;
    case QEvent::Leave:
      lookUnderCursor(nullptr);
      break;
    case QEvent::Wheel:
      if (!wheel_.isValid() || wheel_.elapsed() > FrameScheduler::kRestMilliseconds) isNewView_ = true;
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
  if (event->type() != QEvent::MouseMove) return VtkView::event(event);
  const bool isTaken = VtkView::event(event);
  lookUnderCursor(static_cast<const QMouseEvent*>(event));
  return isTaken;
}

void Viewport::setPreview(const std::optional<SurfacePick>& pick)
{
  editor_.setUnderCursor({pick, editor_.underCursor().constraint});
}

/// Nothing follows the cursor while a button is held, and where it has left (null).
void Viewport::lookUnderCursor(const QMouseEvent* move)
{
  const bool isPreviewed = tool_ != nullptr && tool_->hasPreview();
  UnderCursor found;
  if (isPreviewed) found.pick = editor_.underCursor().pick;
  if (move != nullptr && move->buttons() == Qt::NoButton && contents_ && !isOverOrientation_) {
    const DisplayPoint pixel(std::floor(pixelRatio() * move->localPos().x()),
                             std::ceil(pixelRatio() * (height() - move->localPos().y())) - 1);
    if (!isPreviewed)
      found.pick = SurfacePicker(surface_).pick(*renderer_, pixel.x(), pixel.y(), PickKind::Nearest,
                                                kCursorPixels * pixelRatio());
    marksUnderCursor_->SetPixelRatio(pixelRatio());
    marksUnderCursor_->SetSection(section_ ? &*section_ : nullptr);
    marksUnderCursor_->SetMarks(contents_->sharedMarks());
    const Index constraint = marksUnderCursor_->FindConstraint(pixel.x(), pixel.y());
    if (constraint >= 0) found.constraint = constraint;
  }
  editor_.setUnderCursor(std::move(found));
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
