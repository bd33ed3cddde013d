#include <vtkNew.h>

#include <holdfast/widgets/interaction/surface_point_widget.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/tools/tools.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {
namespace {

class PointTool : public WidgetTool {
 public:
  PointTool(Editor& editor, Viewport& viewport) : WidgetTool(editor, viewport)
  {
    attach(*widget_);
    widget_->AddObserver(vtkCommand::InteractionEvent, this, &PointTool::preview);
    widget_->AddObserver(vtkCommand::PlacePointEvent, this, &PointTool::place);
    widget_->AddObserver(vtkCommand::WidgetValueChangedEvent, this, &PointTool::changed);
  }

  QString hint() const override
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

  void end() override
  {
    WidgetTool::end();
    Q_EMIT viewport().previewChanged(std::nullopt);
  }

  void leave() override
  {
    widget_->HidePreview();
    Q_EMIT viewport().previewChanged(std::nullopt);
  }

  bool wants(const QKeyEvent& event) const override
  {
    const char key = characterOf(event);
    return key != '\0' && widget_->WantsKey(key);
  }

 private:
  void followSurface() override { widget_->SetSurface(viewport().surface()); }

  void followDisplay() override { widget_->SetPixelRatio(viewport().pixelRatio()); }

  void preview(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
  {
    const auto* shown = static_cast<const SurfacePick*>(pick);
    Q_EMIT viewport().previewChanged(shown != nullptr ? std::optional(*shown) : std::nullopt);
  }

  void place(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
  {
    holdPoint(editor(), *static_cast<const SurfacePick*>(pick));
  }

  vtkNew<SurfacePointWidget> widget_;
};

}  // namespace

Tool* newPointTool(Editor& editor, Viewport& viewport)
{
  return new PointTool(editor, viewport);
}

}  // namespace holdfast
