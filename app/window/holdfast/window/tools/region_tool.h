#pragma once
/// \file
/// Selects vertices: with a brush, a rectangle or a lasso, or a whole side with one click.

#include <vector>

#include <vtkNew.h>

#include <holdfast/widgets/interaction/region_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// Joins what the widget reaches with what was selected when the gesture began.
class RegionTool : public WidgetTool {
  Q_OBJECT

 public:
  RegionTool(RegionShape shape, Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  bool cancel() override { return widget_->Cancel(); }

 protected:
  void followSurface() override;
  void followDisplay() override;

 private:
  void start();
  void reach(vtkObject* caller, unsigned long event, void* callData);
  void restore();

  vtkNew<RegionWidget> widget_;
  std::vector<Index> before_;           // selected when the gesture began
  std::weak_ptr<const Model> ofModel_;  // then
};

}  // namespace holdfast
