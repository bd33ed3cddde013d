#pragma once
/// What a user does to constraints: each is one named entry of the history, whichever menu, tool or panel asks for it.

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include <holdfast/document/list_edits.h>
#include <holdfast/document/mirrored.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Places in `Editor::list`, ascending, each once.
using Rows = std::vector<Index>;

/// "P1", or "3 constraints": what an entry of the history is about.
[[nodiscard]] QString subjectOf(const Editor& editor, const Rows& rows);

/// What a constraint becomes; nothing if it stays as it is.
using Change = std::function<std::optional<Constraint>(const Constraint&)>;

/// Makes no entry if all stay as they are. Passes on what `change` throws, and changes nothing then.
void changeConstraints(Editor& editor, const QString& name, const Rows& rows, const Change& change);

/// These three select what they make. `holdPoint` holds the point of the surface where it is now.
void holdPoint(Editor& editor, const SurfacePick& pick);
/// Keeps the vector from the place `to` to the place `from` as it is at rest, rotated as the surface rotates.
void keepVector(Editor& editor, const SurfaceLocation& from, const SurfaceLocation& to);
enum class RegionKind { Fixed, Handle, Rigid };
/// Makes one constraint of the selected vertices, one at least, and deselects them.
void constrainSelection(Editor& editor, RegionKind kind);

void switchConstraints(Editor& editor, const Rows& rows, Enabling enabling);
/// Disables them if all are enabled, else enables all.
void toggleConstraints(Editor& editor, const Rows& rows);
/// Throws `InputError` with the reason if the name is empty or that of another constraint.
void renameConstraint(Editor& editor, Index row, const QString& name);

/// Selects the constraint that is now in the place of the first removed one.
void removeConstraints(Editor& editor, const Rows& rows);

/// Moves `rows` together, in their order, before what is at `to` (the end: the size of the list), and selects them.
void moveConstraints(Editor& editor, const Rows& rows, Index to);
/// Before what precedes the first of them; behind what follows the last.
void moveConstraintsUp(Editor& editor, const Rows& rows);
void moveConstraintsDown(Editor& editor, const Rows& rows);

/// Copies with names of their own at the end of the list, selected.
void duplicateConstraints(Editor& editor, const Rows& rows);

/// Mirrored copies with names of their own at the end of the list, selected. Throws `InputError` as `mirrored` does.
void mirrorConstraints(Editor& editor, const Rows& rows, const MirrorPlane& plane);

/// Points as a point list (CSV), else as a constraint file (JSON). Throws `InputError` for points beside the mesh.
void copyConstraints(const Editor& editor, const Rows& rows);

/// To the end of the list, names made unique, selected. Throws `InputError` for what is neither of these.
void pasteConstraints(Editor& editor);

}  // namespace holdfast
