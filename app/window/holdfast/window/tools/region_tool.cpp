#include <vector>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

class RegionTool : public ToolOf<RegionWidget> {
 public:
  RegionTool(RegionShape shape, Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().SetShape(shape);
    widget().AddObserver(vtkCommand::StartInteractionEvent, this, &RegionTool::start);
    widget().AddObserver(vtkCommand::InteractionEvent, this, &RegionTool::reach);
    widget().AddObserver(vtkCommand::EndInteractionEvent, this, &RegionTool::reach);
    widget().AddObserver(CancelInteractionEvent, this, &RegionTool::restore);
    widget().AddObserver(vtkCommand::WidgetValueChangedEvent, this, &RegionTool::changed);
  }

  QString hint() const override
  {
    const QString outline =
        ' ' + tr("Shift adds, Ctrl takes away, Alt reaches through. Then F: fixed, H: handle, R: rigid");
    switch (widget().GetShape()) {
      case RegionShape::Brush:
        break;
      case RegionShape::Rectangle:
        return tr("Drag a rectangle.") + outline;
      case RegionShape::Lasso:
        return tr("Draw around vertices.") + outline;
      case RegionShape::Side:
        return tr("Click a side that bends by less than %1° an edge ([ and ]). Double click: the whole part. "
                  "Shift adds, Ctrl takes away")
            .arg(widget().GetSideAngle());
    }
    return tr(
        "Paint a region. Shift adds, Ctrl takes away, [ and ] size the brush. Then F: fixed, H: handle, R: rigid");
  }

  bool cancel() override { return widget().Cancel(); }

 private:
  void start()
  {
    before_ = editor().selectedVertices();
    ofModel_ = editor().model();
  }

  void reach(vtkObject* /*caller*/, unsigned long /*event*/, void* callData)
  {
    const auto& [reached, mode] = *static_cast<const RegionCallData*>(callData);
    editor().selectVertices(joined(before_, reached, mode));
  }

  void restore()
  {
    // Another document may have been opened meanwhile.
    if (editor().isOpen() && ofModel_.lock() == editor().model()) editor().selectVertices(before_);
  }

  std::vector<Index> before_;           // the selection when the gesture began
  std::weak_ptr<const Model> ofModel_;  // the model at that time
};

}  // namespace

Tool* newRegionTool(RegionShape shape, Editor& editor, Viewport& viewport)
{
  return new RegionTool(shape, editor, viewport);
}

}  // namespace holdfast
