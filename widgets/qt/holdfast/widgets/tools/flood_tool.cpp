#include "holdfast/widgets/tools/flood_tool.h"

#include <QKeyEvent>
#include <algorithm>

#include <holdfast/widgets/tools/region_selection.h>
#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

constexpr double kStepDegrees = 5;
constexpr double kLargestDegrees = 175;

std::optional<SurfacePick> faceAt(Viewport& viewport, const Pointer& pointer)
{
  return viewport.picker()->pick(viewport.renderer(), pointer.display.x(), pointer.display.y(), PickKind::Face, 0);
}

}  // namespace

FloodTool::FloodTool(Editor& editor, Viewport& viewport, QObject* parent)
    : Tool(parent), editor_(editor), viewport_(viewport)
{
}

QString FloodTool::hint() const
{
  return tr("Click a side that bends by less than %1° an edge ([ and ]). Double click: the whole part. "
            "Shift adds, Ctrl takes away")
      .arg(degrees_);
}

void FloodTool::click(const Pointer& pointer)
{
  const auto pick = faceAt(viewport_, pointer);
  if (!pick) return;
  editor_.selectVertices(joined(editor_.selectedVertices(), editor_.mesh().regions->smooth(pick->face, degrees_),
                                selectionModeOf(pointer.modifiers)));
}

void FloodTool::doubleClick(const Pointer& pointer)
{
  const auto pick = faceAt(viewport_, pointer);
  if (!pick) return;
  const Index vertex = editor_.model()->mesh.faces[pick->face].front();
  editor_.selectVertices(joined(editor_.selectedVertices(), editor_.mesh().regions->connected(vertex),
                                selectionModeOf(pointer.modifiers)));
}

bool FloodTool::key(const QKeyEvent& event)
{
  if (event.key() != Qt::Key_BracketLeft && event.key() != Qt::Key_BracketRight) return false;
  const double step = event.key() == Qt::Key_BracketLeft ? -kStepDegrees : kStepDegrees;
  degrees_ = std::clamp(degrees_ + step, 0.0, kLargestDegrees);
  Q_EMIT changed();
  return true;
}

}  // namespace holdfast
