#pragma once
/// What the mouse does in the viewport while one tool is chosen.

#include <QObject>
#include <QString>
#include <Qt>
#include <vector>

#include <holdfast/base/types.h>

class QKeyEvent;
class QPainter;
class QRect;
class vtkAbstractWidget;

namespace holdfast {

class Editor;
class Viewport;

/// The viewport has one tool at a time. Tools listen to a widget of VTK, which works as long as the tool is chosen, and
/// edit the document; events that the widget leaves move the camera.
class Tool : public QObject {
  Q_OBJECT

 public:
  /// What the left button does, in one line for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;
  [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }

  /// The user has chosen this tool; another one.
  virtual void begin();
  virtual void end();
  /// The mouse is over something in front of what the tool works on.
  virtual void leave() {}
  /// Whether the tool calls `Viewport::setPreview` with what a click would take.
  [[nodiscard]] virtual bool hasPreview() const { return false; }
  /// Whether the tool takes the key, before any menu does.
  [[nodiscard]] virtual bool wants(const QKeyEvent& /*event*/) const { return false; }
  /// The viewport loses the keyboard focus.
  virtual void loseFocus() {}
  /// Takes back what is under way, exactly; false if nothing is.
  virtual bool cancel() { return false; }
  /// Removes what the tool has made last and still holds; false if there is nothing.
  virtual bool remove() { return false; }
  /// Places beside the surface that "show all" shows, too, as the camera stands now; of a document that is open.
  [[nodiscard]] virtual std::vector<Vector3> extent() const { return {}; }
  /// Draws over the picture, in the viewport's own coordinates.
  virtual void paint(QPainter& /*painter*/) const {}

 Q_SIGNALS:
  /// `hint` gives another result now.
  void changed();
  /// `paint` gives another result there.
  void paintChanged(const QRect& area);

 protected:
  /// All outlive the tool.
  Tool(Editor& editor, Viewport& viewport, vtkAbstractWidget& widget, QObject* parent);

  /// The viewport shows another surface, or none.
  virtual void followSurface() {}
  /// Before each picture: the pixel ratio of the display may have changed.
  virtual void followDisplay() {}

  [[nodiscard]] Editor& editor() const noexcept { return editor_; }
  [[nodiscard]] Viewport& viewport() const noexcept { return viewport_; }
  /// As VTK's widgets ask for a key: '\r' for Return, '\b' for Backspace, 27 for Escape; 0 for others or with Ctrl,
  /// Alt.
  [[nodiscard]] static char characterOf(const QKeyEvent& event);

 private:
  Editor& editor_;
  Viewport& viewport_;
  vtkAbstractWidget& vtkWidget_;
};

}  // namespace holdfast
