#pragma once
/// \file
/// What the mouse does in the viewport while one tool is chosen.

#include <QObject>
#include <QPointF>
#include <QString>
#include <Qt>

#include <holdfast/view/camera_motion.h>

class QKeyEvent;
class QPainter;

namespace holdfast {

/// Where the mouse is and what is held.
struct Pointer {
  DisplayPoint display{0, 0};  ///< the pixel of the render window, counted from its lower left corner
  QPointF place;               ///< the same in the viewport's own coordinates: from the upper left corner
  Qt::KeyboardModifiers modifiers;

  /// The middle of the pixel.
  [[nodiscard]] DisplayPoint center() const { return display + DisplayPoint(0.5, 0.5); }
};

/// One of several, of which the viewport holds one at a time. What a tool does not want moves the camera.
class Tool : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// What the left button does, in one line for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;
  [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }

  /// The tool is chosen; another one is.
  virtual void begin() {}
  virtual void end() { cancel(); }

  /// The left button goes down. True: the mouse is the tool's until it comes up again; else the camera's, or a click.
  virtual bool press(const Pointer& /*pointer*/) { return false; }
  /// The mouse moves without a button. True: it is over something of the tool's own, and another tool need not look.
  virtual bool hover(const Pointer& /*pointer*/) { return false; }
  /// The mouse moves after `press` was true.
  virtual void drag(const Pointer& /*pointer*/) {}
  virtual void release(const Pointer& /*pointer*/) {}
  /// The left button went down and up in one place, and `press` was false.
  virtual void click(const Pointer& /*pointer*/) {}
  virtual void doubleClick(const Pointer& /*pointer*/) {}
  /// The mouse left the viewport.
  virtual void leave() {}
  /// Whether `key` would use it: it comes before what menus have the key for.
  [[nodiscard]] virtual bool wants(const QKeyEvent& /*event*/) const { return false; }
  /// True where the tool uses the key.
  virtual bool key(const QKeyEvent& /*event*/) { return false; }

  /// The keyboard goes elsewhere.
  virtual void loseFocus() {}

  /// Takes back what is under way, exactly; false where nothing is.
  virtual bool cancel() { return false; }

  /// Draws over the picture, in the viewport's own coordinates.
  virtual void paint(QPainter& /*painter*/) const {}

 Q_SIGNALS:
  /// What `paint` draws, or `hint` says, has changed.
  void changed();
};

}  // namespace holdfast
