#include "holdfast/window/controls/theme.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>

namespace holdfast {
namespace {

struct Colors {
  const char* window;
  const char* base;
  const char* alternate;
  const char* button;
  const char* text;
  const char* faintText;
  const char* highlight;
  const char* highlightedText;
  const char* link;
  const char* light;
  const char* dark;
};

constexpr Colors kLight{"#f2f3f5", "#ffffff", "#f6f7f9", "#eceef1", "#1c2026", "#8a9099",
                        "#2a6fd6", "#ffffff", "#1b5fc1", "#ffffff", "#b6bbc3"};
constexpr Colors kDark{"#26292e", "#1d2024", "#23262b", "#32363c", "#e4e6ea", "#858b94",
                       "#3b7ddd", "#ffffff", "#7db0ff", "#444951", "#15171a"};

QPalette paletteOf(const Colors& colors)
{
  QPalette palette(QColor(colors.button), QColor(colors.window));
  palette.setColor(QPalette::Base, colors.base);
  palette.setColor(QPalette::AlternateBase, colors.alternate);
  palette.setColor(QPalette::ToolTipBase, colors.base);
  palette.setColor(QPalette::Light, colors.light);
  palette.setColor(QPalette::Dark, colors.dark);
  palette.setColor(QPalette::Mid, colors.dark);
  palette.setColor(QPalette::Highlight, colors.highlight);
  palette.setColor(QPalette::HighlightedText, colors.highlightedText);
  palette.setColor(QPalette::Link, colors.link);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, colors.text);
    palette.setColor(QPalette::Disabled, role, colors.faintText);
  }
  palette.setColor(QPalette::PlaceholderText, colors.faintText);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colors.faintText);
  return palette;
}

}  // namespace

QPalette paletteOf(Appearance appearance)
{
  switch (appearance) {
    case Appearance::Light:
      return paletteOf(kLight);
    case Appearance::Dark:
      return paletteOf(kDark);
    case Appearance::System:
      break;
  }
  // Desktops that say nothing give Qt's grey: only whether it is dark is taken from them.
  return paletteOf(isDark(QApplication::style()->standardPalette()) ? kDark : kLight);
}

bool isDark(const QPalette& palette)
{
  return palette.color(QPalette::WindowText).lightnessF() > palette.color(QPalette::Window).lightnessF();
}

void apply(Appearance appearance)
{
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(paletteOf(appearance));
}

}  // namespace holdfast
