#pragma once
/// \file
/// Keeps the vector between two points of the surface.

#include <vtkNew.h>

#include <holdfast/widgets/interaction/surface_ruler_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// Two clicks make a relative constraint of the vector from the first place to the second. That of a relative
/// constraint that is selected alone is shown as an arrow, whichever tool is chosen.
class RelativeTool : public WidgetTool {
  Q_OBJECT

 public:
  RelativeTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  bool cancel() override;

 protected:
  void followSurface() override;
  void followDisplay() override;

 private:
  void forgetRefusal();
  void keep();
  void showSelected();

  QString refusal_;  // of the last two clicks; empty where they made a constraint
  vtkNew<SurfaceRulerWidget> widget_;
  vtkNew<SurfaceRulerRepresentation> selected_;
};

}  // namespace holdfast
