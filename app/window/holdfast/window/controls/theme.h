#pragma once
/// \file
/// Light and dark.

#include <QPalette>

namespace holdfast {

enum class Appearance { System, Light, Dark };

/// The colours of the window; for `System` those that the desktop says.
[[nodiscard]] QPalette paletteOf(Appearance appearance);

/// Whether text is lighter than what it is written on.
[[nodiscard]] bool isDark(const QPalette& palette);

/// Gives the whole program this look.
void apply(Appearance appearance);

}  // namespace holdfast
