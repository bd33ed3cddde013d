#pragma once
/// \file
/// How the modifiers of a gesture in Qt join what it reaches with what is selected.

#include <Qt>

#include <holdfast/view/interaction/selection_mode.h>

namespace holdfast {

/// Shift adds, Ctrl takes away.
[[nodiscard]] SelectionMode selectionModeOf(Qt::KeyboardModifiers modifiers);

}  // namespace holdfast
