#pragma once
/// \file
/// The base of tools that listen to a widget of VTK.

#include <holdfast/window/model/editor.h>
#include <holdfast/window/viewport/tool.h>

class vtkAbstractWidget;

namespace holdfast {

class Viewport;

/// Its widget works in the viewport as long as the tool is chosen.
class WidgetTool : public Tool {
  Q_OBJECT

 public:
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  void begin() override;
  void end() override;

 protected:
  /// `widget` stays alive as long as this.
  WidgetTool(Editor& editor, Viewport& viewport, QObject* parent = nullptr)
      : Tool(parent), editor_(editor), viewport_(viewport)
  {
  }

  /// To be called once, by the constructor.
  void attach(vtkAbstractWidget& widget);

  /// The viewport shows another surface, or none.
  virtual void followSurface() {}
  /// Before each picture: the pixel ratio of the display may have changed.
  virtual void followDisplay() {}

  [[nodiscard]] Editor& editor() const noexcept { return editor_; }
  [[nodiscard]] Viewport& viewport() const noexcept { return viewport_; }

 private:
  Editor& editor_;
  Viewport& viewport_;
  vtkAbstractWidget* widget_ = nullptr;
};

/// The character that a key stands for, as widgets of VTK ask for it: '\r' for Return, '\b' for Backspace, 27 for
/// Escape; 0 for others, and with Ctrl, Alt or Meta.
[[nodiscard]] char characterOf(const QKeyEvent& event);

}  // namespace holdfast
