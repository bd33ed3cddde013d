#pragma once
/// Makes the light and the dark theme: colours of the window and of what VTK draws in it.

#include <QPalette>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

enum class Appearance { System, Light, Dark };

/// Returns the contrast of the luminances of two colours, from 1 to 21, as WCAG 2.2 defines it.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

/// Returns the palette of this look; for `System` the palette of the desktop.
[[nodiscard]] QPalette paletteOf(Appearance appearance);

/// Gives the whole program this look; for `System` the look of the desktop.
void apply(Appearance appearance);

/// Tells whether text is lighter than what it is written on.
[[nodiscard]] bool isDark(const QPalette& palette);

[[nodiscard]] QColor toQColor(const Color& color);

/// The colours of pictures inside panels.
struct PictureColors {
  Color ground;  ///< as behind texts that are edited
  Color raised;  ///< a little off the ground
  Color grid;    ///< quiet lines
  Color ink;     ///< texts and strong lines
  Color bar;     ///< areas that are data
  Color accent;  ///< marks; differs from `bar` and `ink` in hue and lightness
};

[[nodiscard]] PictureColors pictureColors(const QPalette& palette);

}  // namespace holdfast
