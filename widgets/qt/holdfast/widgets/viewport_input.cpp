// What the mouse and the keys do in the viewport.

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/viewport.h>
#include <holdfast/widgets/viewport_overlay.h>

namespace holdfast {
namespace {

// Of the widget's pixels: a hand that shakes less than this clicks.
constexpr double kClickReach = 4;

// A hand across the height of the viewport turns the picture by this.
constexpr double kDegreesAcross = 220;

// A notch of the wheel, 120 of Qt's units.
constexpr double kWheelZoom = 1.2;

}  // namespace

void Viewport::setTool(Tool* tool)
{
  if (tool_ == tool) return;
  cancelGesture();
  setPreview(std::nullopt);
  if (tool_) {
    tool_->end();
    disconnect(tool_, nullptr, overlay_, nullptr);
  }
  tool_ = tool;
  if (tool_) {
    tool_->begin();
    connect(tool_, &Tool::changed, overlay_, qOverload<>(&QWidget::update));
  }
  setCursor(tool_ ? tool_->cursor() : Qt::ArrowCursor);
  paintTools();
}

void Viewport::setFirstTool(Tool* tool)
{
  firstTool_ = tool;
  paintTools();
}

void Viewport::paintTools()
{
  std::vector<const Tool*> tools;
  for (const Tool* tool : {tool_, firstTool_})
    if (tool) tools.push_back(tool);
  overlay_->setTools(std::move(tools));
}

bool Viewport::cancelGesture()
{
  const bool wasUnderWay = pressed_ != nullptr;
  if (pressed_) pressed_->cancel();
  pressed_ = nullptr;
  // The camera's gestures have nothing to take back, and stop where they are.
  hand_ = Hand::Empty;
  return wasUnderWay || (firstTool_ && firstTool_->cancel()) || (tool_ && tool_->cancel());
}

DisplayPoint Viewport::toDisplayPoint(const QPointF& place) const
{
  // The middle of the pixel under the cursor's tip.
  return {std::floor(place.x() * pixelRatio()), std::floor((height() - place.y()) * pixelRatio() - 0.5)};
}

QPointF Viewport::toPlace(const DisplayPoint& display) const
{
  return {display.x() / pixelRatio(), height() - display.y() / pixelRatio()};
}

Pointer Viewport::pointerAt(const QPointF& place, Qt::KeyboardModifiers modifiers) const
{
  return {toDisplayPoint(place), place, modifiers};
}

bool Viewport::event(QEvent* event)
{
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      press(static_cast<const QMouseEvent&>(*event));
      return true;
    case QEvent::MouseMove:
      move(static_cast<const QMouseEvent&>(*event));
      return true;
    case QEvent::MouseButtonRelease:
      release(static_cast<const QMouseEvent&>(*event));
      return true;
    case QEvent::MouseButtonDblClick:
      if (tool_ && static_cast<const QMouseEvent&>(*event).button() == Qt::LeftButton)
        tool_->doubleClick(pointerAt(static_cast<const QMouseEvent&>(*event).localPos(),
                                     static_cast<const QMouseEvent&>(*event).modifiers()));
      return true;
    case QEvent::Wheel:
      wheel(static_cast<const QWheelEvent&>(*event));
      return true;
    case QEvent::Leave:
      if (hand_ == Hand::Empty)
        for (Tool* tool : {firstTool_, tool_})
          if (tool) tool->leave();
      break;
    case QEvent::ShortcutOverride:
      for (const Tool* tool : {firstTool_, tool_}) {
        if (!tool || !tool->wants(static_cast<const QKeyEvent&>(*event))) continue;
        event->accept();
        return true;
      }
      break;
    case QEvent::KeyPress:
      for (Tool* tool : {firstTool_, tool_})
        if (tool && tool->key(static_cast<const QKeyEvent&>(*event))) return true;
      event->ignore();
      return false;
    case QEvent::FocusOut:
      for (Tool* tool : {firstTool_, tool_})
        if (tool) tool->loseFocus();
      break;
    case QEvent::KeyRelease:
    case QEvent::ContextMenu:
      return true;
    default:
      break;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

bool Viewport::offerPress(const Pointer& pointer)
{
  for (Tool* tool : {firstTool_, tool_}) {
    if (!tool || !tool->press(pointer)) continue;
    pressed_ = tool;
    return true;
  }
  return false;
}

void Viewport::press(const QMouseEvent& event)
{
  if (!contents_ || hand_ != Hand::Empty) return;
  button_ = event.button();
  pressedAt_ = event.localPos();
  movedTo_ = pressedAt_;
  if (button_ == Qt::LeftButton && offerPress(pointerAt(pressedAt_, event.modifiers()))) {
    hand_ = Hand::Tool;
    return;
  }
  if (button_ == Qt::MiddleButton || (button_ == Qt::RightButton && event.modifiers() & Qt::ShiftModifier))
    return beginCamera(Hand::Pan, pressedAt_);
  hand_ = Hand::Pressed;
}

void Viewport::move(const QMouseEvent& event)
{
  const QPointF place = event.localPos();
  if (!contents_) return;
  const Pointer pointer = pointerAt(place, event.modifiers());
  switch (hand_) {
    case Hand::Empty:
      return hover(pointer);
    case Hand::Tool:
      return pressed_->drag(pointer);
    case Hand::Pressed:
      if (std::hypot(place.x() - pressedAt_.x(), place.y() - pressedAt_.y()) < kClickReach) return;
      beginCamera(Hand::Orbit, pressedAt_);
      [[fallthrough]];
    case Hand::Orbit:
    case Hand::Pan:
      turnOrShift(place);
  }
}

void Viewport::hover(const Pointer& pointer)
{
  const bool isTaken = firstTool_ && firstTool_->hover(pointer);
  if (tool_ && isTaken) tool_->leave();
  if (tool_ && !isTaken) static_cast<void>(tool_->hover(pointer));
}

void Viewport::release(const QMouseEvent& event)
{
  if (event.button() != button_) return;
  const Hand hand = std::exchange(hand_, Hand::Empty);
  button_ = Qt::NoButton;
  const Pointer pointer = pointerAt(event.localPos(), event.modifiers());
  if (Tool* tool = std::exchange(pressed_, nullptr); tool && hand == Hand::Tool) tool->release(pointer);
  if (hand == Hand::Pressed && event.button() == Qt::LeftButton && tool_) tool_->click(pointer);
  if (hand == Hand::Pressed && event.button() == Qt::RightButton) Q_EMIT contextMenuWanted(event.pos());
  // What was coarse while the hand moved is drawn in full when it rests.
  if (isCoarse_) restTimer_.start();
}

void Viewport::wheel(const QWheelEvent& event)
{
  if (!contents_) return;
  const double factor = std::pow(kWheelZoom, event.angleDelta().y() / 120.0);
  zoom(*renderer_, placeUnder(toDisplayPoint(event.position())), factor);
  cameraMoved();
}

Vector3 Viewport::placeUnder(const DisplayPoint& display)
{
  if (const auto pick = picker_->pick(*renderer_, display.x(), display.y(), PickKind::Face, 0)) return pick->place;
  return atDepthOf(*renderer_, Vector3(renderer_->GetActiveCamera()->GetFocalPoint()), display);
}

void Viewport::beginCamera(Hand hand, const QPointF& place)
{
  hand_ = hand;
  pivot_ = placeUnder(toDisplayPoint(place));
  setPreview(std::nullopt);
}

void Viewport::turnOrShift(const QPointF& to)
{
  const QPointF from = std::exchange(movedTo_, to);
  if (hand_ == Hand::Pan) {
    pan(*renderer_, pivot_, toDisplayPoint(from), toDisplayPoint(to));
  } else {
    const double degrees = kDegreesAcross / std::max(1, height());
    orbit(*renderer_->GetActiveCamera(), pivot_, degrees * (to.x() - from.x()), degrees * (from.y() - to.y()));
  }
  cameraMoved();
}

}  // namespace holdfast
