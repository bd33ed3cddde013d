#include "holdfast/window/tools/ruler_tool.h"

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

RulerTool::RulerTool(Editor& editor, Viewport& viewport, QObject* parent) : WidgetTool(editor, viewport, parent)
{
  attach(*widget_);
  for (const unsigned long event :
       {static_cast<unsigned long>(vtkCommand::PlacePointEvent), static_cast<unsigned long>(CancelInteractionEvent)})
    widget_->AddObserver(event, this, &RulerTool::changed);
}

QString RulerTool::hint() const
{
  if (widget_->GetLocation(1)) return tr("Drag an end to measure elsewhere; Escape takes the ruler away");
  if (widget_->GetLocation(0)) return tr("Click the second point; Escape takes the first one back");
  return tr("Click two points of the surface to measure between them, now and at rest");
}

void RulerTool::followSurface()
{
  widget_->SetSurface(viewport().surface());
  if (editor().isOpen()) widget_->SetUnits(editor().list().units);
}

void RulerTool::followDisplay()
{
  widget_->SetPixelRatio(viewport().pixelRatio());
}

bool RulerTool::cancel()
{
  if (!widget_->GetLocation(0)) return false;
  if (widget_->IsUnderWay()) {
    widget_->Cancel();
  } else {
    widget_->Clear();
    widget_->Render();
  }
  Q_EMIT changed();
  return true;
}

}  // namespace holdfast
