#pragma once
/// \file
/// What the mouse does in the viewport while one tool is chosen.

#include <QObject>
#include <QString>
#include <Qt>

class QKeyEvent;
class QPainter;

namespace holdfast {

/// One of several, of which the viewport holds one at a time. Tools listen to widgets of VTK and edit the document;
/// what the widgets leave moves the camera.
class Tool : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// What the left button does, in one line for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;
  [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }

  /// The tool is chosen; another one is.
  virtual void begin() = 0;
  virtual void end() = 0;

  /// Something in front of what the tool works on has the mouse.
  virtual void leave() {}

  /// Whether the key is the tool's: it comes before what menus have it for.
  [[nodiscard]] virtual bool wants(const QKeyEvent& /*event*/) const { return false; }

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
