#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/surface_ruler_widget.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

class RulerTool : public ToolOf<SurfaceRulerWidget> {
 public:
  RulerTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    setObjectName("rulerTool");
    widget().AddObserver(vtkCommand::PlacePointEvent, this, &RulerTool::changed);
    widget().AddObserver(CancelInteractionEvent, this, &RulerTool::changed);
  }

  QString hint() const override
  {
    if (widget().GetLocation(1)) return tr("Drag an end to measure elsewhere; Escape takes the ruler away");
    if (widget().GetLocation(0)) return tr("Click the second point; Escape takes the first one back");
    return tr("Click two points of the surface to measure between them, now and at rest");
  }

  bool cancel() override
  {
    if (!widget().GetLocation(0)) return false;
    if (widget().IsUnderWay()) {
      widget().Cancel();
    } else {
      widget().Clear();
      widget().Render();
    }
    Q_EMIT changed();
    return true;
  }

 private:
  void followSurface() override
  {
    ToolOf::followSurface();
    if (editor().isOpen()) widget().SetUnits(editor().list().units);
  }
};

}  // namespace

Tool* newRulerTool(Editor& editor, Viewport& viewport)
{
  return new RulerTool(editor, viewport);
}

}  // namespace holdfast
