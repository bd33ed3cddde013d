#pragma once
/// The panel that lists constraints: find, sort, reorder, switch, type targets, copy and paste.

#include <QWidget>
#include <functional>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// A double click on a row, in a cell that cannot be edited, calls `activated` with its place in the list.
[[nodiscard]] QWidget* newConstraintPanel(Editor& editor, const std::function<void(Index)>& activated);

}  // namespace holdfast
