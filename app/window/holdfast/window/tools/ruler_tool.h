#pragma once
/// \file
/// Measures between two points of the surface.

#include <vtkNew.h>

#include <holdfast/widgets/interaction/surface_ruler_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// Two clicks place a ruler, which follows the surface and shows the distance now and at rest. Its ends can be dragged;
/// Escape takes it away. It is there as long as the tool is chosen.
class RulerTool : public WidgetTool {
  Q_OBJECT

 public:
  RulerTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  bool cancel() override;

  [[nodiscard]] SurfaceRulerWidget& widget() const { return *widget_; }

 protected:
  void followSurface() override;
  void followDisplay() override;

 private:
  vtkNew<SurfaceRulerWidget> widget_;
};

}  // namespace holdfast
