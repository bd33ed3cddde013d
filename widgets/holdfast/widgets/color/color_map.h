#pragma once
/// Colour maps and scales turn numbers into colours. Equal steps along a map look equal. A scale places values on a
/// map.

#include <optional>
#include <string>

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

namespace holdfast {

/// A colour in sRGB. Each channel goes from 0 to 1.
struct Color {
  double red = 0;
  double green = 0;
  double blue = 0;

  friend bool operator==(const Color&, const Color&) = default;
};

/// Returns the colour that is `share` of the way from `from` to `to`.
[[nodiscard]] Color mixed(const Color& from, const Color& to, double share);

/// The maps of colours. Equal steps of each map look about equal. With any common colour blindness, no two colours of
/// one map look the same.
enum class ColorMap {
  BlueGreenYellow,  ///< from dark blue over green to yellow
  BlueGreyYellow,   ///< from dark blue over grey to yellow: looks nearly the same with and without red and green
  BlueWhiteOrange,  ///< from blue over white to orange, lightest in the middle: for values on either side of one
  Grey,             ///< from black to a middling grey: leaves all colours to other things
  BlueWhiteRed,     ///< from blue over white to red, lightest in the middle
  BlackRedYellow    ///< from black over red to light yellow
};

/// Returns the colour at `share` of the map. A share outside [0, 1] is clamped, and NaN gives `kNoValueColor`.
/// Lightness rises all the way, or as far as the middle of a two-sided map.
[[nodiscard]] Color mapColor(double share, ColorMap map = ColorMap::BlueGreenYellow);

/// Places without a value have this light grey. No map has it.
inline constexpr Color kNoValueColor{0.80, 0.80, 0.80};

/// Tells whether the lightest colour of `map` is in its middle.
[[nodiscard]] constexpr bool isTwoSided(ColorMap map)
{
  return map == ColorMap::BlueWhiteOrange || map == ColorMap::BlueWhiteRed;
}

/// Where a scale marks what is outside it, values below its beginning have the first colour. Values beyond its end have
/// the second. No map has these colours.
inline constexpr Color kBelowColor{0.125, 0.00, 0.625};
inline constexpr Color kBeyondColor{0.75, 1.00, 0.00};

/// The colour of values that are not on the scale.
enum class Outside {
  AsEnds,  ///< they have the colour of the nearer end
  Marked   ///< they have `kBelowColor` or `kBeyondColor`
};

enum class Scaling { Linear, Logarithmic };

/// Which numbers are round on a linear scale.
enum class TickSteps {
  Decimal,  ///< 1, 2 and 5 times powers of ten
  Degrees   ///< 15, 30, 45 and 90 degrees and whole turns; decimal below
};

/// A scale has no more bands than this. The eye hardly tells more apart.
inline constexpr int kMostBands = 64;

/// A scale says which colour of a map each value has.
///
///     ColorScale scale{"displacement\n[mm]", Scaling::Linear, 0, 25};
///     scale.bands = 5;
///     const Color color = colorOf(scale, 12.5);
///     mapper->SetLookupTable(toLookupTable(scale));  // a vtkMapper whose scalars are tablePlace(scale, value)
///     mapper->UseLookupTableScalarRangeOn();
struct ColorScale {
  std::string title;  ///< may hold line breaks
  Scaling scaling = Scaling::Linear;
  double low = 0;   ///< the value at the beginning of the map; above 0 on a logarithmic scale
  double high = 1;  ///< the value at the end of the map; above `low`
  std::optional<double> promise = std::nullopt;  ///< a value to mark: all below it is as good as promised
  TickSteps steps = TickSteps::Decimal;
  ColorMap map = ColorMap::BlueGreenYellow;
  /// The number of bands, 2 or more. Each has one colour, and all are equally wide. With 0 the colour changes with
  /// every value.
  int bands = 0;
  bool isSigned =
      false;  ///< 0 has the middle colour of a two-sided map, also where the ends are not equally far from it
  Outside outside = Outside::AsEnds;

  friend bool operator==(const ColorScale&, const ColorScale&) = default;
};

/// Returns where `value` lies between the ends of the scale, from 0 to 1. Values beyond an end give that end, and NaN
/// gives NaN.
[[nodiscard]] double shareOf(const ColorScale& scale, double value);

/// Returns the colour at `share` of the way from the beginning of the scale to its end. The first band has the colour
/// at the beginning of the map, the last one that at its end. The place where two bands meet belongs to the upper one.
[[nodiscard]] Color colorAt(const ColorScale& scale, double share);

/// Returns the colour of `value` on the scale.
[[nodiscard]] Color colorOf(const ColorScale& scale, double value);

/// Makes the table of colours of a scale for VTK. VTK looks a value up in it by its `tablePlace`.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> toLookupTable(const ColorScale& scale);

/// Returns the place at which VTK finds the colour of `value` in the table. It goes from 0 to 1. Where the scale marks
/// what is outside, it is below 0 or above 1 there. NaN gives NaN.
///
/// No value falls between two colours of the table, neither an end of the scale nor a value at which two bands meet.
/// Drawing would choose either colour from pixel to pixel there.
[[nodiscard]] double tablePlace(const ColorScale& scale, double value);

}  // namespace holdfast
