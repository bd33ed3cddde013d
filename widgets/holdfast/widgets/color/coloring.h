#pragma once
/// \file
/// What a surface can be coloured by, and the numbers and the scale of each.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

enum class ColorBy {
  None,                ///< one colour
  ConstraintResidual,  ///< how far constraints are from being met; logarithmic, the promise marked
  Rotation,            ///< |q|, half the angle by which the detail is turned, radians
  Angle,               ///< the whole of it, degrees, not wrapped
  Displacement,        ///< the length of the way from rest
  Detail,              ///< how far the detail is from that at rest, turned
  Force                ///< how hard constraints pull; logarithmic. Of hard constraints only, else nowhere a value
};

/// The names on command lines, in the order of `ColorBy`: "none", "constraint-residual", "rotation", ...
[[nodiscard]] std::span<const std::string_view> colorByNames();

[[nodiscard]] std::optional<ColorBy> colorByNamed(std::string_view name);

/// One number for each vertex of the file, NaN where there is none, and what they mean as colours.
struct Coloring {
  std::vector<double> values;
  ColorScale scale;
};

/// None for `ColorBy::None`. `units` is the user's name of the model's length; it may be empty.
[[nodiscard]] std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation, ColorBy colorBy,
                                                 const std::string& units);

}  // namespace holdfast
