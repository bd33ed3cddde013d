#pragma once
/// What a field says at a place of the surface.

#include <holdfast/constraints/constraint.h>
#include <holdfast/widgets/color/coloring.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// The value of a colouring of the open document, as it is drawn there; NaN where there is none.
[[nodiscard]] double fieldValue(const Editor& editor, const Coloring& coloring, const SurfaceLocation& location);

}  // namespace holdfast
