#include "holdfast/window/tools/region_tool.h"

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

RegionTool::RegionTool(RegionShape shape, Editor& editor, Viewport& viewport, QObject* parent)
    : WidgetTool(editor, viewport, parent)
{
  attach(*widget_);
  widget_->SetShape(shape);
  widget_->AddObserver(vtkCommand::StartInteractionEvent, this, &RegionTool::start);
  widget_->AddObserver(vtkCommand::InteractionEvent, this, &RegionTool::reach);
  widget_->AddObserver(vtkCommand::EndInteractionEvent, this, &RegionTool::reach);
  widget_->AddObserver(CancelInteractionEvent, this, &RegionTool::restore);
  widget_->AddObserver(vtkCommand::WidgetValueChangedEvent, this, &RegionTool::changed);
}

QString RegionTool::hint() const
{
  const QString outline = tr("Shift adds, Ctrl takes away, Alt reaches through. Then F: fixed, H: handle, R: rigid");
  switch (widget_->GetShape()) {
    case RegionShape::Brush:
      break;
    case RegionShape::Rectangle:
      return tr("Drag a rectangle.") + ' ' + outline;
    case RegionShape::Lasso:
      return tr("Draw around vertices.") + ' ' + outline;
    case RegionShape::Side:
      return tr("Click a side that bends by less than %1° an edge ([ and ]). Double click: the whole part. "
                "Shift adds, Ctrl takes away")
          .arg(widget_->GetSideAngle());
  }
  return tr("Paint a region. Shift adds, Ctrl takes away, [ and ] size the brush. Then F: fixed, H: handle, R: rigid");
}

void RegionTool::followSurface()
{
  widget_->SetSurface(viewport().surface());
  widget_->SetRegions(editor().isOpen() ? editor().mesh().regions : nullptr);
}

void RegionTool::followDisplay()
{
  widget_->SetPixelRatio(viewport().pixelRatio());
}

void RegionTool::start()
{
  before_ = editor().selectedVertices();
  ofModel_ = editor().model();
}

void RegionTool::reach(vtkObject* /*caller*/, unsigned long /*event*/, void* callData)
{
  const auto& [reached, mode] = *static_cast<const RegionCallData*>(callData);
  editor().selectVertices(joined(before_, reached, mode));
}

void RegionTool::restore()
{
  // Another document may have been opened meanwhile.
  if (editor().isOpen() && ofModel_.lock() == editor().model()) editor().selectVertices(before_);
}

}  // namespace holdfast
