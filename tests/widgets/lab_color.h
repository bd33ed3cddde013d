#pragma once
/// \file
/// Colours as people see them.

#include <holdfast/widgets/color/color_map.h>

namespace holdfast::test {

/// CIE L*a*b* under D65: equal distances look about equally large.
struct LabColor {
  double lightness = 0;  ///< 0 black, 100 white
  double a = 0;
  double b = 0;
};

[[nodiscard]] LabColor toLab(const Color& color);

[[nodiscard]] double distance(const LabColor& p, const LabColor& q);

/// Eyes, with all receptors, and without those for green or for red (deuteranopia, protanopia).
enum class Vision { Usual, WithoutGreen, WithoutRed };

/// The colour as it looks to such an eye (Machado, Oliveira and Fernandes, 2009).
[[nodiscard]] Color seenBy(Vision vision, const Color& color);

}  // namespace holdfast::test
