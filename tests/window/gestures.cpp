#include "gestures.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QWidget>
#include <QWindow>

namespace holdfast::test {
namespace {

constexpr int kMillisecondsBetweenLooks = 10;

// Everything takes so many times as long under the thread sanitizer.
#ifdef __SANITIZE_THREAD__
constexpr int kSlower = 10;
#else
constexpr int kSlower = 1;
#endif

void send(QWidget& widget, QEvent::Type type, const QPointF& place, Qt::MouseButton button, Qt::MouseButtons buttons,
          Qt::KeyboardModifiers modifiers)
{
  const QPointF global = widget.mapToGlobal(QPoint(0, 0)) + place;
  const QPointF inWindow = widget.mapTo(widget.window(), QPoint(0, 0)) + place;
  QMouseEvent event(type, place, inWindow, global, button, buttons, modifiers);
  QApplication::sendEvent(&widget, &event);
}

}  // namespace

bool waitUntil(const std::function<bool()>& condition, std::chrono::milliseconds limit)
{
  QElapsedTimer timer;
  timer.start();
  // Not every condition comes true with an event.
  QTimer lookAgain;
  lookAgain.start(kMillisecondsBetweenLooks);
  while (!condition()) {
    if (timer.elapsed() > kSlower * limit.count()) return false;
    // Without a time of its own: with one Qt does not wait, and takes a whole core from what is waited for.
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return true;
}

bool isOpaque(const QImage& picture)
{
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qAlpha(picture.pixel(x, y)) != 255) return false;
  return true;
}

bool showAndWait(QWidget& widget)
{
  widget.show();
  return waitUntil([&] { return widget.windowHandle() != nullptr && widget.windowHandle()->isExposed(); });
}

void moveMouse(QWidget& widget, const QPointF& place, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers)
{
  send(widget, QEvent::MouseMove, place, Qt::NoButton, buttons, modifiers);
}

void pressMouse(QWidget& widget, const QPointF& place, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
  send(widget, QEvent::MouseButtonPress, place, button, button, modifiers);
}

void releaseMouse(QWidget& widget, const QPointF& place, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
  send(widget, QEvent::MouseButtonRelease, place, button, Qt::NoButton, modifiers);
}

void click(QWidget& widget, const QPointF& place, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
  moveMouse(widget, place, Qt::NoButton, modifiers);
  pressMouse(widget, place, button, modifiers);
  releaseMouse(widget, place, button, modifiers);
}

void doubleClick(QWidget& widget, const QPointF& place, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
  click(widget, place, button, modifiers);
  send(widget, QEvent::MouseButtonDblClick, place, button, button, modifiers);
  releaseMouse(widget, place, button, modifiers);
}

void drag(QWidget& widget, const std::vector<QPointF>& way, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
  moveMouse(widget, way.front(), Qt::NoButton, modifiers);
  pressMouse(widget, way.front(), button, modifiers);
  for (const QPointF& place : way) moveMouse(widget, place, button, modifiers);
  releaseMouse(widget, way.back(), button, modifiers);
}

QString textOf(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
  if (key == Qt::Key_Return || key == Qt::Key_Enter) return "\r";
  if (key == Qt::Key_Backspace) return "\b";
  if (key == Qt::Key_Escape) return "\x1b";
  if (key >= Qt::Key_Space && key <= Qt::Key_AsciiTilde)
    return modifiers & Qt::ShiftModifier ? QString(QChar(key)) : QString(QChar(key)).toLower();
  return {};
}

void pressKey(QWidget& widget, Qt::Key key, Qt::KeyboardModifiers modifiers)
{
  const QString text = textOf(key, modifiers);
  // Shortcuts come before keys, as they do in a real window.
  QKeyEvent shortcut(QEvent::ShortcutOverride, key, modifiers, text);
  QApplication::sendEvent(&widget, &shortcut);
  QKeyEvent press(QEvent::KeyPress, key, modifiers, text);
  QApplication::sendEvent(&widget, &press);
  QKeyEvent release(QEvent::KeyRelease, key, modifiers, text);
  QApplication::sendEvent(&widget, &release);
}

void type(QWidget& widget, const char* text)
{
  for (const QChar& character : QString::fromUtf8(text)) {
    QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, QString(character));
    QApplication::sendEvent(&widget, &press);
    QKeyEvent release(QEvent::KeyRelease, 0, Qt::NoModifier, QString(character));
    QApplication::sendEvent(&widget, &release);
  }
}

}  // namespace holdfast::test
