#pragma once
/// \file
/// Selects constraints by their glyphs.

#include <vtkNew.h>

#include <holdfast/widgets/interaction/constraint_mark_widget.h>
#include <holdfast/window/tools/widget_tool.h>

namespace holdfast {

/// A click on a glyph selects its constraint, with Shift or Ctrl besides those that are selected; a click beside all
/// selects none.
class SelectTool : public WidgetTool {
  Q_OBJECT

 public:
  SelectTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;

 protected:
  void followDisplay() override;

 private:
  void followMarks();
  void pick(vtkObject* caller, unsigned long event, void* picked);

  vtkNew<ConstraintMarkWidget> widget_;
};

}  // namespace holdfast
