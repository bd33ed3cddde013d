#pragma once
/// Reads the value of a field at a place of the surface.

#include <holdfast/constraints/constraint.h>
#include <holdfast/widgets/color/coloring.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Returns the value of a colouring of the open document, as it is drawn at `location`; NaN where there is none.
[[nodiscard]] double fieldValue(const Editor& editor, const Coloring& coloring, const SurfaceLocation& location);

}  // namespace holdfast
