#pragma once
/// \file
/// Places points of the surface that are to be held.

#include <vtkNew.h>

#include <holdfast/widgets/interaction/surface_point_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// A click holds the point under the cursor where it is. V, E and F take vertices, edges or faces only; A what is
/// nearest.
class PointTool : public WidgetTool {
  Q_OBJECT

 public:
  PointTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  void end() override;
  void leave() override;
  [[nodiscard]] bool wants(const QKeyEvent& event) const override;

  [[nodiscard]] SurfacePointWidget& widget() { return *widget_; }

 protected:
  void followSurface() override;
  void followDisplay() override;

 private:
  void preview(vtkObject* caller, unsigned long event, void* pick);
  void place(vtkObject* caller, unsigned long event, void* pick);

  vtkNew<SurfacePointWidget> widget_;
};

}  // namespace holdfast
