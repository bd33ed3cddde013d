#include <holdfast/widgets/interaction/surface_point_widget.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {
namespace {

class PointTool : public ToolOf<SurfacePointWidget> {
 public:
  PointTool(Editor& editor, Viewport& viewport) : ToolOf(editor, viewport)
  {
    widget().AddObserver(vtkCommand::InteractionEvent, this, &PointTool::preview);
    widget().AddObserver(vtkCommand::PlacePointEvent, this, &PointTool::place);
    widget().AddObserver(vtkCommand::WidgetValueChangedEvent, this, &PointTool::changed);
  }

  QString hint() const override
  {
    switch (widget().GetKind()) {
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
    ToolOf::end();
    Q_EMIT viewport().previewChanged(std::nullopt);
  }

  void leave() override
  {
    widget().HidePreview();
    Q_EMIT viewport().previewChanged(std::nullopt);
  }

  bool wants(const QKeyEvent& event) const override
  {
    const char key = characterOf(event);
    return key != '\0' && widget().WantsKey(key);
  }

 private:
  void preview(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
  {
    const auto* shown = static_cast<const SurfacePick*>(pick);
    Q_EMIT viewport().previewChanged(shown != nullptr ? std::optional(*shown) : std::nullopt);
  }

  void place(vtkObject* /*caller*/, unsigned long /*event*/, void* pick)
  {
    holdPoint(editor(), *static_cast<const SurfacePick*>(pick));
  }
};

}  // namespace

Tool* newPointTool(Editor& editor, Viewport& viewport)
{
  return new PointTool(editor, viewport);
}

}  // namespace holdfast
