#pragma once
/// \file
/// What the mouse does in the viewport while one tool is chosen.

#include <QObject>
#include <QString>
#include <Qt>

class QKeyEvent;
class QPainter;

namespace holdfast {

/// The viewport has one tool at a time. Tools listen to widgets of VTK and edit the document; events that the widgets
/// leave move the camera.
class Tool : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// What the left button does, in one line for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;
  [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }

  /// The user has chosen this tool; another one.
  virtual void begin() = 0;
  virtual void end() = 0;

  /// The mouse is over something in front of what the tool works on.
  virtual void leave() {}

  /// Whether the tool takes the key, before any menu does.
  [[nodiscard]] virtual bool wants(const QKeyEvent& /*event*/) const { return false; }

  /// The viewport loses the keyboard focus.
  virtual void loseFocus() {}

  /// Takes back what is under way, exactly; false if nothing is.
  virtual bool cancel() { return false; }

  /// Draws over the picture, in the viewport's own coordinates.
  virtual void paint(QPainter& /*painter*/) const {}

 Q_SIGNALS:
  /// `paint` or `hint` gives another result now.
  void changed();
};

}  // namespace holdfast
