#pragma once
/// Icons that are drawn, so they are sharp on every screen and follow the palette.

#include <QIcon>
#include <QPainterPath>
#include <QPalette>
#include <functional>

namespace holdfast {

enum class Sign {
  Select,
  Point,
  Relative,
  Brush,
  Rectangle,
  Lasso,
  Flood,
  Curve,
  Ruler,
  Probe,
  Fix,
  Handle,
  Rigid,
  Undo,
  Redo,
  Frame,
  Through
};

/// In the colour of the palette's text, faint where disabled.
[[nodiscard]] QIcon iconOf(Sign sign, const QPalette& palette);

/// Of the program: a surface that a point holds.
[[nodiscard]] QIcon programIcon();

/// `draw` draws it on a square of this side.
[[nodiscard]] QIcon drawnIcon(double side, std::function<void(QPainter& painter, QIcon::Mode mode)> draw);

/// Commands of SVG paths with absolute coordinates (M x y, L x y, C x y x y x y, Z); and O x y r for a circle.
[[nodiscard]] QPainterPath drawnPath(const char* text);

}  // namespace holdfast
