#include "holdfast/widgets/tools/select_tool.h"

#include <algorithm>

#include <holdfast/view/display_transform.h>
#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

// Of the viewport's pixels.
constexpr double kReach = 9;

}  // namespace

SelectTool::SelectTool(Editor& editor, Viewport& viewport, QObject* parent)
    : Tool(parent), editor_(editor), viewport_(viewport)
{
}

QString SelectTool::hint() const
{
  return tr("Click a constraint to select it, drag to turn the picture");
}

std::optional<Index> SelectTool::constraintAt(const Pointer& pointer) const
{
  double nearest = kReach * viewport_.pixelRatio();
  std::optional<Index> found;
  const DisplayTransform toDisplay(viewport_.renderer());
  for (const ConstraintMark& mark : viewport_.marks()) {
    const DisplayTransform::Shown shown = toDisplay.show(mark.place);
    if (shown.depth <= 0) continue;
    const double distance = (shown.point - pointer.display).norm();
    // Of what lies in one place single points come before regions: they are what a hand aims at.
    const double judged = isSinglePoint(mark.kind) ? distance : distance + 2;
    if (judged >= nearest) continue;
    nearest = judged;
    found = mark.constraint;
  }
  return found;
}

bool SelectTool::hover(const Pointer& pointer)
{
  const bool isOver = constraintAt(pointer).has_value();
  viewport_.setCursor(isOver ? Qt::PointingHandCursor : cursor());
  return isOver;
}

void SelectTool::click(const Pointer& pointer)
{
  const auto found = constraintAt(pointer);
  const bool isMore = pointer.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
  if (!isMore) return editor_.selectConstraints(found ? std::vector{*found} : std::vector<Index>{});
  if (!found) return;
  auto selected = editor_.selectedConstraints();
  if (std::erase(selected, *found) == 0) selected.push_back(*found);
  editor_.selectConstraints(std::move(selected));
}

}  // namespace holdfast
