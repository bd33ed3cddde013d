#pragma once
/// \file
/// The colours of the gizmo: red, green and blue that differ in lightness as well, so that they are told apart with
/// every common colour blindness.

#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/gizmo/gizmo_part.h>

namespace holdfast {

inline constexpr Color kHighlightColor{0.98, 0.76, 0.18};

/// Of a part that is not highlighted.
[[nodiscard]] constexpr Color gizmoColor(GizmoPart part)
{
  switch (axisIndexOf(part)) {
    case 0:
      return {0.84, 0.27, 0.24};
    case 1:
      return {0.33, 0.74, 0.52};
    case 2:
      return {0.15, 0.36, 0.74};
    default:
      return part == GizmoPart::ViewRing ? Color{0.50, 0.53, 0.58} : Color{0.93, 0.94, 0.96};
  }
}

}  // namespace holdfast
