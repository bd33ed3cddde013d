#include "holdfast/window/tools/point_tool.h"

#include <holdfast/window/model/commands.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

PointTool::PointTool(Editor& editor, Viewport& viewport, QObject* parent) : WidgetTool(editor, viewport, parent)
{
  attach(*widget_);
  widget_->AddObserver(vtkCommand::InteractionEvent, this, &PointTool::preview);
  widget_->AddObserver(vtkCommand::PlacePointEvent, this, &PointTool::place);
  widget_->AddObserver(vtkCommand::WidgetValueChangedEvent, this, &PointTool::changed);
}

QString PointTool::hint() const
{
  switch (widget_->GetKind()) {
    case PickKind::Vertex:
      return tr("Click a vertex to hold it. E: edges, F: faces, A: whatever is nearest");
    case PickKind::Edge:
      return tr("Click an edge to hold a point of it. V: vertices, F: faces, A: whatever is nearest");
    case PickKind::Face:
      return tr("Click a face to hold a point of it. V: vertices, E: edges, A: whatever is nearest");
    case PickKind::Nearest:
      break;
  }
  return tr("Click a point of the surface to hold it. V: vertices only, E: edges, F: faces");
}

void PointTool::followSurface()
{
  widget_->SetSurface(viewport().surface());
}

void PointTool::followDisplay()
{
  widget_->SetPixelRatio(viewport().pixelRatio());
}

void PointTool::leave()
{
  widget_->HidePreview();
  Q_EMIT viewport().previewChanged(std::nullopt);
}

void PointTool::end()
{
  WidgetTool::end();
  Q_EMIT viewport().previewChanged(std::nullopt);
}

bool PointTool::wants(const QKeyEvent& event) const
{
  const char key = characterOf(event);
  return key != '\0' && widget_->WantsKey(key);
}

void PointTool::preview(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
{
  const auto* shown = static_cast<const SurfacePick*>(pick);
  Q_EMIT viewport().previewChanged(shown != nullptr ? std::optional(*shown) : std::nullopt);
}

void PointTool::place(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
{
  holdPoint(editor(), *static_cast<const SurfacePick*>(pick));
}

}  // namespace holdfast
