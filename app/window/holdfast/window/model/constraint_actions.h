#pragma once
/// Does what a user does to constraints. Each action is one named entry of the history, whichever menu, tool or panel
/// asks for it.

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include <holdfast/document/list_edits.h>
#include <holdfast/document/mirrored.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Holds places in `Editor::list`, ascending and each once.
using Rows = std::vector<Index>;

/// Returns what an entry of the history is about: "P1", or "3 constraints".
[[nodiscard]] QString subjectOf(const Editor& editor, const Rows& rows);

/// Returns what a constraint becomes; nothing if it stays as it is.
using Change = std::function<std::optional<Constraint>(const Constraint&)>;

/// Changes each constraint by `change`. If all stay as they are, there is no entry. If `change` throws, nothing changes
/// and the exception is passed on.
void changeConstraints(Editor& editor, const QString& name, const Rows& rows, const Change& change);

/// Adds a constraint at the end of the list under a name of its own, which begins with `stem`, and selects it.
void addConstraint(Editor& editor, const char* stem, decltype(Constraint::what) what);
/// Keeps the points and slides of `rows` on another mesh. Without rows it adds a slide of the selected vertices.
void keepOnMesh(Editor& editor, const Rows& rows, const OnMesh& on);
/// Holds a point of the surface where it is now, and selects the constraint.
void holdPoint(Editor& editor, const SurfacePick& pick);

void switchConstraints(Editor& editor, const Rows& rows, Enabling enabling);
/// Disables the constraints if all are enabled, else enables all.
void toggleConstraints(Editor& editor, const Rows& rows);
/// Renames a constraint. Throws `InputError` with the reason if the name is empty or another constraint has it.
void renameConstraint(Editor& editor, Index row, const QString& name);

/// Removes constraints. Then it selects the constraint that is now in the place of the first removed one, or else the
/// last one.
void removeConstraints(Editor& editor, const Rows& rows);

/// Moves `rows` together, in their order, before the constraint at `to`, and selects them. For the end of the list,
/// `to` is the size of the list.
void moveConstraints(Editor& editor, const Rows& rows, Index to);
/// Moves `rows` before the constraint that precedes the first of them.
void moveConstraintsUp(Editor& editor, const Rows& rows);
/// Moves `rows` behind the constraint that follows the last of them.
void moveConstraintsDown(Editor& editor, const Rows& rows);

/// Adds copies at the end of the list, gives them names of their own, and selects them.
void duplicateConstraints(Editor& editor, const Rows& rows);

/// Adds mirrored copies at the end of the list, gives them names of their own, and selects them. Throws `InputError` as
/// `mirrored` does.
void mirrorConstraints(Editor& editor, const Rows& rows, const MirrorPlane& plane);

/// Copies constraints to the clipboard. Points become a point list (CSV), other constraints a constraint file (JSON).
/// Throws `InputError` for points beside the mesh.
void copyConstraints(const Editor& editor, const Rows& rows);

/// Pastes constraints from the clipboard at the end of the list, makes their names unique, and selects them. Throws
/// `InputError` if the clipboard holds neither a point list nor a constraint file.
void pasteConstraints(Editor& editor);

}  // namespace holdfast
