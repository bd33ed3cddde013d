#pragma once
/// \file
/// The window's colours for what VTK draws inside it, light or dark as the palette is.

#include <QColor>
#include <QPalette>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

[[nodiscard]] inline Color toColor(const QColor& color)
{
  return {color.redF(), color.greenF(), color.blueF()};
}

[[nodiscard]] inline QColor toQColor(const Color& color)
{
  return QColor::fromRgbF(color.red, color.green, color.blue);
}

/// `from` with `share` of `to`.
[[nodiscard]] inline Color between(const Color& from, const Color& to, double share)
{
  return {from.red + share * (to.red - from.red), from.green + share * (to.green - from.green),
          from.blue + share * (to.blue - from.blue)};
}

/// Grounds and inks of pictures inside panels.
struct PictureColors {
  Color ground;  ///< as behind texts that are edited
  Color raised;  ///< a little off the ground
  Color grid;    ///< quiet lines
  Color ink;     ///< texts and strong lines
  Color bar;     ///< areas that are data
  Color accent;  ///< marks; differs from `bar` and `ink` in hue and lightness
};

[[nodiscard]] inline PictureColors pictureColors(const QPalette& palette)
{
  PictureColors colors;
  colors.ground = toColor(palette.color(QPalette::Base));
  colors.ink = toColor(palette.color(QPalette::Text));
  colors.raised = between(colors.ground, colors.ink, 0.09);
  colors.grid = between(colors.ground, colors.ink, 0.18);
  const bool isDark = palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness();
  colors.bar = isDark ? Color{0.42, 0.62, 0.86} : Color{0.24, 0.44, 0.70};
  colors.accent = isDark ? Color{1.00, 0.60, 0.25} : Color{0.86, 0.34, 0.04};
  return colors;
}

}  // namespace holdfast
