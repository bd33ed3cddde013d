#pragma once
/// The colours of numbers: maps along which equal steps look equal, and scales that place values on them.

#include <optional>
#include <string>

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

namespace holdfast {

/// sRGB, each from 0 to 1.
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;

  friend bool operator==(const Color&, const Color&) = default;
};

/// The colour that is `share` of the way from `from` to `to`.
[[nodiscard]] Color mixed(const Color& from, const Color& to, double share);

/// Equal steps of each map look about equal, and no two colours of one look the same with any common colour blindness.
enum class ColorMap {
  BlueGreenYellow,  ///< from dark blue over green to yellow
  BlueGreyYellow,   ///< from dark blue over grey to yellow: looks nearly the same with and without red and green
  BlueWhiteOrange,  ///< from blue over white to orange, lightest in the middle: for what lies on either side of a value
  Grey,             ///< from black to a middling grey: leaves all colours to other things
  BlueWhiteRed,     ///< from blue over white to red, lightest in the middle
  BlackRedYellow    ///< from black over red to light yellow
};

/// The colour at `share` in [0, 1] (clamped; `kNoValueColor` for NaN). Lightness rises all the way, or to the middle.
[[nodiscard]] Color mapColor(double share, ColorMap map = ColorMap::BlueGreenYellow);

/// A light grey that the maps do not have, for places without a value.
inline constexpr Color kNoValueColor{0.80, 0.80, 0.80};

/// Whether its lightest colour is in its middle.
[[nodiscard]] constexpr bool isTwoSided(ColorMap map)
{
  return map == ColorMap::BlueWhiteOrange || map == ColorMap::BlueWhiteRed;
}

/// What is below the beginning of a scale and beyond its end, where that is marked: colours that no map has.
inline constexpr Color kBelowColor{0.125, 0.00, 0.625};
inline constexpr Color kBeyondColor{0.75, 1.00, 0.00};

/// The colour of values that are not on the scale.
enum class Outside {
  AsEnds,  ///< that of the nearer end
  Marked   ///< `kBelowColor` and `kBeyondColor`
};

enum class Scaling { Linear, Logarithmic };

/// Which numbers are round on a linear scale.
enum class TickSteps {
  Decimal,  ///< 1, 2 and 5 times powers of ten
  Degrees   ///< 15, 30, 45 and 90 degrees and whole turns; decimal below
};

/// More are hardly told apart.
inline constexpr int kMostBands = 64;

/// The meaning of values on the map.
struct ColorScale {
  std::string title;  ///< may hold line breaks
  Scaling scaling = Scaling::Linear;
  double low = 0;                                ///< the value at the map's beginning; larger than 0 where logarithmic
  double high = 1;                               ///< the value at its end, larger than `low`
  std::optional<double> promise = std::nullopt;  ///< a value to mark: what is below it is as good as promised
  TickSteps steps = TickSteps::Decimal;
  ColorMap map = ColorMap::BlueGreenYellow;
  int bands = 0;  ///< of one colour each, all equally wide, 2 or more; 0: colours change with every value
  bool isSigned =
      false;  ///< 0 has the middle colour of a two-sided map, also where the ends are not equally far from it
  Outside outside = Outside::AsEnds;

  friend bool operator==(const ColorScale&, const ColorScale&) = default;
};

/// Where `value` lies between the ends of the scale, from 0 to 1 and no farther; NaN for NaN.
[[nodiscard]] double shareOf(const ColorScale& scale, double value);

/// The colour at `share` of the way from the beginning of the scale to its end. The first band has the colour of the
/// map's beginning, the last one that of its end; where two bands meet, the upper one begins.
[[nodiscard]] Color colorAt(const ColorScale& scale, double share);

[[nodiscard]] Color colorOf(const ColorScale& scale, double value);

/// The colours of a scale for VTK, over `tablePlace`.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> toLookupTable(const ColorScale& scale);

/// Where VTK finds the colour of `value`: 0 to 1, less or more outside where that is marked; NaN for NaN. No value lies
/// between two colours of the table, where drawing would choose either from pixel to pixel: not one of an end, and none
/// at which two bands meet.
[[nodiscard]] double tablePlace(const ColorScale& scale, double value);

}  // namespace holdfast
