#pragma once
/// \file
/// What menus, keys and tools do to the document: each is one edit with a name, and selects what it made.

#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Holds the point of the surface where it is now.
void holdPoint(Editor& editor, const SurfacePick& pick);

/// Keeps the vector from the place `to` to the place `from` as it is at rest, turned as the surface turns.
void keepVector(Editor& editor, const SurfaceLocation& from, const SurfaceLocation& to);

enum class RegionKind { Fixed, Handle, Rigid };

/// Makes one constraint of the selected vertices, which are deselected. Some are selected.
void constrainSelection(Editor& editor, RegionKind kind);

/// Of the selected constraints; harmless where none is.
void removeSelectedConstraints(Editor& editor);
/// Disables them where all are enabled, else enables all.
void toggleSelectedConstraints(Editor& editor);

}  // namespace holdfast
