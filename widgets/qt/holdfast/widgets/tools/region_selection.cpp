#include "holdfast/widgets/tools/region_selection.h"

namespace holdfast {

SelectionMode selectionModeOf(Qt::KeyboardModifiers modifiers)
{
  if (modifiers & Qt::ControlModifier) return SelectionMode::Remove;
  return modifiers & Qt::ShiftModifier ? SelectionMode::Add : SelectionMode::Replace;
}

}  // namespace holdfast
