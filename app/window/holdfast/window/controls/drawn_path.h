#pragma once
/// Shapes of icons as text.

#include <QPainterPath>

namespace holdfast {

/// Understands the commands of SVG paths that icons need, each with its letter and absolute coordinates: M x y, L x y,
/// C x y x y x y, Z; and O x y r for a circle.
[[nodiscard]] QPainterPath drawnPath(const char* text);

}  // namespace holdfast
