#pragma once
/// \file
/// What a user does to constraints of the list, one named entry of the history each, whichever panel asks for it.

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Places in `Editor::list`, ascending, each once.
using Rows = std::vector<Index>;

/// "P1", or "3 constraints": what an entry of the history is about.
[[nodiscard]] QString subjectOf(const Editor& editor, const Rows& rows);

/// What a constraint becomes; nothing where it stays as it is.
using Change = std::function<std::optional<Constraint>(const Constraint&)>;

/// Every one of `rows` as `change` makes it. No entry where all stay as they are. Throws what `change` throws, and
/// nothing is changed then.
void changeConstraints(Editor& editor, const QString& name, const Rows& rows, const Change& change);

void enableConstraints(Editor& editor, const Rows& rows);
void disableConstraints(Editor& editor, const Rows& rows);

/// Throws `InputError` with the reason where the name is empty or that of another one.
void renameConstraint(Editor& editor, Index row, const QString& name);

/// The constraint that is in the place of the first removed one is selected then.
void removeConstraints(Editor& editor, const Rows& rows);

/// Moves `rows` together, in their order, before what is at `to` (the end: the size of the list), and selects them.
void moveConstraints(Editor& editor, const Rows& rows, Index to);
/// Before what precedes the first of them; behind what follows the last.
void moveConstraintsUp(Editor& editor, const Rows& rows);
void moveConstraintsDown(Editor& editor, const Rows& rows);

/// Copies with names of their own at the end of the list, selected.
void duplicateConstraints(Editor& editor, const Rows& rows);

/// To the clipboard: points as a point list (CSV), anything else as a constraint file (JSON). Throws `InputError` for
/// points that are not on the mesh.
void copyConstraints(const Editor& editor, const Rows& rows);

/// From the clipboard to the end of the list, names made unique, selected. Throws `InputError` for what is neither a
/// point list nor a constraint file.
void pasteConstraints(Editor& editor);

}  // namespace holdfast
