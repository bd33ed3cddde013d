#include "holdfast/widgets/interaction/selection_mode.h"

#include <algorithm>
#include <iterator>

#include <vtkRenderWindowInteractor.h>

namespace holdfast {

SelectionMode selectionModeOf(vtkRenderWindowInteractor& interactor)
{
  if (interactor.GetControlKey() != 0) return SelectionMode::Remove;
  return interactor.GetShiftKey() != 0 ? SelectionMode::Add : SelectionMode::Replace;
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
