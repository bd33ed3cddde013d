#pragma once
/// The base of tools. The chosen tool decides what the mouse does in the viewport.

#include <QObject>
#include <QString>
#include <Qt>
#include <vector>

#include <holdfast/numbers/types.h>

class QKeyEvent;
class QPainter;
class QRect;
class vtkAbstractWidget;

namespace holdfast {

class Editor;
class Viewport;

/// A tool listens to a widget of VTK and edits the document. The viewport has one chosen tool at a time. The widget
/// works as long as its tool is chosen. Events that the widget leaves move the camera.
class Tool : public QObject {
  Q_OBJECT

 public:
  /// Returns what the left button does, in one line for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;
  [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }

  /// These two are called when the user has chosen this tool, and when the user has chosen another one.
  virtual void begin();
  virtual void end();
  /// This is called when something in front of the surface is under the mouse.
  virtual void leave() {}
  /// Tells whether the tool calls `Viewport::setPreview` with what a click would take.
  [[nodiscard]] virtual bool hasPreview() const { return false; }
  /// Tells whether the tool takes the key before any menu does.
  [[nodiscard]] virtual bool wants(const QKeyEvent& /*event*/) const { return false; }
  /// This is called when the viewport loses the keyboard focus.
  virtual void loseFocus() {}
  /// Takes back exactly what is under way. Returns false if nothing is.
  virtual bool cancel() { return false; }
  /// Removes what the tool has made last and still holds. Returns false if there is nothing.
  virtual bool remove() { return false; }
  /// Returns places beside the surface that "show all" shows, too, as the camera stands now. A document is open.
  [[nodiscard]] virtual std::vector<Vector3> extent() const { return {}; }
  /// Draws over the picture, in the viewport's own coordinates.
  virtual void paint(QPainter& /*painter*/) const {}

 Q_SIGNALS:
  /// `hint` returns another result now.
  void changed();
  /// `paint` draws something else in this area now.
  void paintChanged(const QRect& area);

 protected:
  /// Makes a tool. All arguments outlive it.
  Tool(Editor& editor, Viewport& viewport, vtkAbstractWidget& widget, QObject* parent);

  /// This is called when the viewport shows another surface, or none.
  virtual void followSurface() {}
  /// This is called before each picture: the pixel ratio of the display may have changed.
  virtual void followDisplay() {}

  [[nodiscard]] Editor& editor() const noexcept { return editor_; }
  [[nodiscard]] Viewport& viewport() const noexcept { return viewport_; }
  /// Returns a key as VTK's widgets ask for it: its character, '\r' for Return, '\b' for Backspace, 27 for Escape. It
  /// returns 0 for other keys, and with Ctrl or Alt.
  [[nodiscard]] static char characterOf(const QKeyEvent& event);

 private:
  Editor& editor_;
  Viewport& viewport_;
  vtkAbstractWidget& vtkWidget_;
};

}  // namespace holdfast
