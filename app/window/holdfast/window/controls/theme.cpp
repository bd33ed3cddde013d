#include "holdfast/window/controls/theme.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>
#include <algorithm>
#include <array>
#include <cmath>

namespace holdfast {
namespace {

struct RoleColors {
  QPalette::ColorRole role;
  const char* light;
  const char* dark;
};

constexpr std::array kColors{RoleColors{QPalette::Base, "#ffffff", "#1d2024"},
                             RoleColors{QPalette::AlternateBase, "#f6f7f9", "#23262b"},
                             RoleColors{QPalette::ToolTipBase, "#ffffff", "#1d2024"},
                             RoleColors{QPalette::Light, "#ffffff", "#444951"},
                             RoleColors{QPalette::Dark, "#b6bbc3", "#15171a"},
                             RoleColors{QPalette::Mid, "#b6bbc3", "#15171a"},
                             RoleColors{QPalette::Highlight, "#2a6fd6", "#2f6fd0"},
                             RoleColors{QPalette::HighlightedText, "#ffffff", "#ffffff"},
                             RoleColors{QPalette::Link, "#1b5fc1", "#7db0ff"},
                             RoleColors{QPalette::WindowText, "#1c2026", "#e4e6ea"},
                             RoleColors{QPalette::Text, "#1c2026", "#e4e6ea"},
                             RoleColors{QPalette::ButtonText, "#1c2026", "#e4e6ea"},
                             RoleColors{QPalette::ToolTipText, "#1c2026", "#e4e6ea"},
                             RoleColors{QPalette::PlaceholderText, "#6a7079", "#9aa0a9"}};

Color toColor(const QColor& color)
{
  return {color.redF(), color.greenF(), color.blueF()};
}

}  // namespace

bool isDark(const QPalette& palette)
{
  return palette.color(QPalette::WindowText).lightnessF() > palette.color(QPalette::Window).lightnessF();
}

double contrast(const QColor& a, const QColor& b)
{
  const auto luminance = [](const QColor& color) {
    const auto light = [](double channel) {
      return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * light(color.redF()) + 0.7152 * light(color.greenF()) + 0.0722 * light(color.blueF());
  };
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

QPalette paletteOf(Appearance appearance)
{
  // Desktops that say nothing give Qt's grey: only whether it is dark is taken from them.
  const bool isDarkWanted = appearance == Appearance::System ? isDark(QApplication::style()->standardPalette())
                                                             : appearance == Appearance::Dark;
  QPalette palette(QColor(isDarkWanted ? "#32363c" : "#eceef1"), QColor(isDarkWanted ? "#26292e" : "#f2f3f5"));
  for (const auto& [role, light, dark] : kColors) palette.setColor(role, isDarkWanted ? dark : light);
  const QColor faint(isDarkWanted ? "#858b94" : "#8a9099");
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::Highlight})
    palette.setColor(QPalette::Disabled, role, faint);
  return palette;
}

void apply(Appearance appearance)
{
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(paletteOf(appearance));
}

QColor toQColor(const Color& color)
{
  return QColor::fromRgbF(color.red, color.green, color.blue);
}

PictureColors pictureColors(const QPalette& palette)
{
  const Color ground = toColor(palette.color(QPalette::Base));
  const Color ink = toColor(palette.color(QPalette::Text));
  const Color bar = isDark(palette) ? Color{0.42, 0.62, 0.86} : Color{0.24, 0.44, 0.70};
  const Color accent = isDark(palette) ? Color{1.00, 0.60, 0.25} : Color{0.86, 0.34, 0.04};
  return {ground, mixed(ground, ink, 0.09), mixed(ground, ink, 0.18), ink, bar, accent};
}

}  // namespace holdfast
