#pragma once
/// Selections that the user keeps under names, and selects again.

#include <QString>

#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Keeps the selected vertices, of which there are some, under the first of "selection 1", "selection 2", ... that is
/// free; a curve as a curve. One entry of the history, as all that follow.
void saveSelection(Editor& editor);

/// Throws `InputError` for a name that is empty or taken.
void renameSavedSelection(Editor& editor, Index place, const QString& name);

/// Those at `places`, ascending.
void removeSavedSelections(Editor& editor, const Rows& places);

/// In place of what is selected. Throws `InputError` where the mesh has no such vertices.
void selectSaved(Editor& editor, Index place);

}  // namespace holdfast
