#pragma once
/// Shows saved selections in the menu of the main window.

#include <QMainWindow>
#include <QMenu>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Keeps the selected vertices, and has the panel of `window` ask for their name.
void saveAndNameSelection(Editor& editor, QMainWindow& window);

/// Makes a menu with an entry for each saved selection, which selects it. The editor outlives the menu; `window` owns
/// it.
[[nodiscard]] QMenu* newSavedSelectionMenu(Editor& editor, QMainWindow& window);

}  // namespace holdfast
