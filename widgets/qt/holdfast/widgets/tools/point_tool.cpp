#include "holdfast/widgets/tools/point_tool.h"

#include <QKeyEvent>

#include <holdfast/widgets/commands.h>
#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

// Of the viewport's pixels.
constexpr double kSnapReach = 7;

std::optional<PickKind> chosenBy(const QKeyEvent& event)
{
  if (event.modifiers() != Qt::NoModifier) return std::nullopt;
  switch (event.key()) {
    case Qt::Key_V:
      return PickKind::Vertex;
    case Qt::Key_E:
      return PickKind::Edge;
    case Qt::Key_F:
      return PickKind::Face;
    case Qt::Key_A:
      return PickKind::Nearest;
    default:
      return std::nullopt;
  }
}

}  // namespace

PointTool::PointTool(Editor& editor, Viewport& viewport, QObject* parent)
    : Tool(parent), editor_(editor), viewport_(viewport)
{
}

QString PointTool::hint() const
{
  switch (kind_) {
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

std::optional<SurfacePick> PointTool::pickAt(const Pointer& pointer)
{
  const SurfacePicker* picker = viewport_.picker();
  if (!picker) return std::nullopt;
  return picker->pick(viewport_.renderer(), pointer.display.x(), pointer.display.y(), kind_,
                      kSnapReach * viewport_.pixelRatio());
}

void PointTool::end()
{
  viewport_.setPreview(std::nullopt);
}

bool PointTool::hover(const Pointer& pointer)
{
  last_ = pointer;
  viewport_.setPreview(pickAt(pointer));
  return true;
}

void PointTool::leave()
{
  viewport_.setPreview(std::nullopt);
}

void PointTool::click(const Pointer& pointer)
{
  if (const auto pick = pickAt(pointer)) holdPoint(editor_, *pick);
}

bool PointTool::wants(const QKeyEvent& event) const
{
  return chosenBy(event).has_value();
}

bool PointTool::key(const QKeyEvent& event)
{
  const auto kind = chosenBy(event);
  if (!kind) return false;
  kind_ = *kind;
  viewport_.setPreview(pickAt(last_));
  Q_EMIT changed();
  return true;
}

}  // namespace holdfast
