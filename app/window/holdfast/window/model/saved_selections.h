#pragma once
/// Keeps selections under names, so that the user can select them again.

#include <QString>

#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Keeps the selected vertices under the first name of "selection 1", "selection 2", ... that is free. A curve is kept
/// as a curve. At least one vertex is selected. Each of the first three functions here adds one entry to the history.
void saveSelection(Editor& editor);

/// Renames a saved selection. Throws `InputError` for a name that is empty or taken.
void renameSavedSelection(Editor& editor, Index place, const QString& name);

/// Removes the selections at `places`, which are ascending.
void removeSavedSelections(Editor& editor, const Rows& places);

/// Selects a saved selection instead of the present one. Throws `InputError` where the mesh has no such vertices.
void selectSaved(Editor& editor, Index place);

}  // namespace holdfast
