#pragma once
/// \file
/// How the modifiers of a gesture join what it reaches with what is selected.

#include <Qt>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

enum class SelectionMode { Replace, Add, Remove };

/// Shift adds, Ctrl takes away.
[[nodiscard]] SelectionMode selectionModeOf(Qt::KeyboardModifiers modifiers);

/// Both ascending, each id once; so the result. O(sum of both).
[[nodiscard]] std::vector<Index> joined(const std::vector<Index>& selected, const std::vector<Index>& reached,
                                        SelectionMode mode);

}  // namespace holdfast
