#pragma once
/// The legend of a picture shows a bar of colours with its title and numbers, and a key of the glyphs.

#include <optional>
#include <string>
#include <vector>

#include <vtkRenderer.h>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

/// One line of the key shows a ball in a colour and says what it means.
struct KeyEntry {
  Color color;
  std::string text;
};

/// The contents of a legend: a scale and a key. Without a scale it has no bar.
struct LegendContents {
  std::optional<ColorScale> scale;
  std::vector<KeyEntry> key;

  [[nodiscard]] bool isEmpty() const { return !scale && key.empty(); }
};

/// The place of the legend, in pixels of the window from its lower left corner.
struct LegendPlace {
  double left = 0;
  double width = 0;
  double height = 0;  ///< the height of the window; the legend keeps its own margins
  double textSize = 0;
};

/// A number beside the bar: the value, and the text that is written for it.
struct Tick {
  double value = 0;
  std::string text;
};

/// Returns the smallest number that is no less than `least` and is 1, 2 or 5 times a power of ten.
[[nodiscard]] double roundStep(double least);

/// Returns about five round numbers on the scale, ascending. On a logarithmic scale they are powers of ten. On a scale
/// of bands they are its ends and the values where bands meet, or evenly some of these.
[[nodiscard]] std::vector<Tick> ticksOf(const ColorScale& scale);

/// Adds the legend to a renderer that fills the window.
///
///     LegendContents legend{coloring.scale, {}};
///     legend.key.push_back({glyphColor(ConstraintStatus::Met), "12 met"});
///     addLegend(*renderer, legend, {.left = 1100, .width = 180, .height = 960, .textSize = 18});
void addLegend(vtkRenderer& renderer, const LegendContents& contents, const LegendPlace& place);

}  // namespace holdfast
