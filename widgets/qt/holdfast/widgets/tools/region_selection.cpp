#include "holdfast/widgets/tools/region_selection.h"

#include <algorithm>
#include <iterator>

namespace holdfast {

SelectionMode selectionModeOf(Qt::KeyboardModifiers modifiers)
{
  if (modifiers & Qt::ControlModifier) return SelectionMode::Remove;
  return modifiers & Qt::ShiftModifier ? SelectionMode::Add : SelectionMode::Replace;
}

std::vector<Index> joined(const std::vector<Index>& selected, const std::vector<Index>& reached, SelectionMode mode)
{
  std::vector<Index> result;
  switch (mode) {
    case SelectionMode::Replace:
      return reached;
    case SelectionMode::Add:
      std::set_union(selected.begin(), selected.end(), reached.begin(), reached.end(), std::back_inserter(result));
      break;
    case SelectionMode::Remove:
      std::set_difference(selected.begin(), selected.end(), reached.begin(), reached.end(), std::back_inserter(result));
      break;
  }
  return result;
}

}  // namespace holdfast
