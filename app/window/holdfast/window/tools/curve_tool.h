#pragma once
/// \file
/// Draws a closed curve on the surface around a feature.

#include <QString>

#include <vtkNew.h>

#include <holdfast/widgets/interaction/surface_curve_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// A closed curve selects what is inside it, again each time that one of its places is dragged. A constraint made of it
/// keeps the curve, not the ids. Whatever else is selected takes the curve away.
class CurveTool : public WidgetTool {
  Q_OBJECT

 public:
  CurveTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  void end() override;
  bool cancel() override { return widget_->Cancel(); }

 protected:
  void followSurface() override;
  void followDisplay() override;

 private:
  void followCurve();
  void selectInside();
  void followSelection();

  vtkNew<SurfaceCurveWidget> widget_;
  QString error_;  // why the closed curve selects nothing
  bool isSelecting_ = false;
};

}  // namespace holdfast
