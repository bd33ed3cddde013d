#pragma once
/// \file
/// How what a gesture reaches is joined with what is selected.

#include <vector>

#include <holdfast/base/types.h>

class vtkRenderWindowInteractor;

namespace holdfast {

enum class SelectionMode { Replace, Add, Remove };

/// Of the event that is being handled: Shift adds, Ctrl takes away.
[[nodiscard]] SelectionMode selectionModeOf(vtkRenderWindowInteractor& interactor);

/// Both ascending, each id once; so the result. O(sum of both).
[[nodiscard]] std::vector<Index> joined(const std::vector<Index>& selected, const std::vector<Index>& reached,
                                        SelectionMode mode);

}  // namespace holdfast
