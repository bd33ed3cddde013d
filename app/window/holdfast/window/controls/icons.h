#pragma once
/// Draws icons, which are therefore sharp on every screen and follow the palette.

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

/// Returns an icon in the colour of the palette's text. It is faint where it is disabled.
[[nodiscard]] QIcon iconOf(Sign sign, const QPalette& palette);

/// Returns the icon of the program: a surface that a point holds.
[[nodiscard]] QIcon programIcon();

/// Returns an icon that `draw` draws on a square of this side.
[[nodiscard]] QIcon drawnIcon(double side, std::function<void(QPainter& painter, QIcon::Mode mode)> draw);

/// Returns the path that `text` describes. The text has commands of SVG paths with absolute coordinates (M x y, L x y,
/// C x y x y x y, Z). Besides, O x y r is a circle.
[[nodiscard]] QPainterPath drawnPath(const char* text);

}  // namespace holdfast
