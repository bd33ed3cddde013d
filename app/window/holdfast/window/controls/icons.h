#pragma once
/// The signs on the buttons of the window. They are drawn, so they are sharp on every screen and follow the palette.

#include <QIcon>
#include <QPalette>

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
  Fix,
  Handle,
  Rigid,
  Undo,
  Redo,
  Frame
};

/// In the colour of the palette's text, faint where disabled.
[[nodiscard]] QIcon iconOf(Sign sign, const QPalette& palette);

}  // namespace holdfast
