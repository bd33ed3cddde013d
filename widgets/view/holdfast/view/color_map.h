#pragma once
/// \file
/// The colours of numbers: a map whose lightness rises evenly, and scales that place values on it.

#include <optional>
#include <string>

#include <vtkSmartPointer.h>

class vtkLookupTable;

namespace holdfast {

/// sRGB, each from 0 to 1.
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;

  friend bool operator==(const Color&, const Color&) = default;
};

/// CIE L*a*b* under D65: equal distances look about equally large.
struct LabColor {
  double lightness = 0;  ///< 0 black, 100 white
  double a = 0;
  double b = 0;
};

[[nodiscard]] LabColor toLab(const Color& color);

/// The map, from dark blue over green to yellow, for `share` in [0, 1] (clamped; `kNoValueColor` for NaN). Lightness
/// rises all the way, so that it reads without colours too, and equal steps look about equal; blue against yellow is
/// told apart with every common colour blindness.
[[nodiscard]] Color mapColor(double share);

/// A quiet grey that the map does not have: there is no value here.
inline constexpr Color kNoValueColor{0.80, 0.80, 0.80};

enum class Scaling { Linear, Logarithmic };

/// Which numbers are round on a linear scale.
enum class TickSteps {
  Decimal,  ///< 1, 2 and 5 times powers of ten
  Degrees   ///< 15, 30, 45 and 90 degrees and whole turns; decimal below
};

/// What values mean on the map.
struct ColorScale {
  std::string title;  ///< may hold line breaks
  Scaling scaling = Scaling::Linear;
  double low = 0;                                ///< the value at the map's beginning; larger than 0 where logarithmic
  double high = 1;                               ///< the value at its end, larger than `low`
  std::optional<double> promise = std::nullopt;  ///< a value to mark: what is below it is as good as promised
  TickSteps steps = TickSteps::Decimal;
};

/// Where `value` lies between the ends of the scale, from 0 to 1 and no farther; NaN for NaN.
[[nodiscard]] double shareOf(const ColorScale& scale, double value);

[[nodiscard]] Color colorOf(const ColorScale& scale, double value);

/// The map for VTK, over shares from 0 to 1.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> toLookupTable();

}  // namespace holdfast
