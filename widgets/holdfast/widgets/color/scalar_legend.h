#pragma once
/// The legend of a picture: a bar of colours with its title and numbers, and a key of the glyphs.

#include <optional>
#include <string>
#include <vector>

#include <vtkRenderer.h>

#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

/// One line of the key: the colour of a ball and its meaning.
struct KeyEntry {
  Color color;
  std::string text;
};

struct LegendContents {
  std::optional<ColorScale> scale;
  std::vector<KeyEntry> key;

  [[nodiscard]] bool isEmpty() const { return !scale && key.empty(); }
};

/// Where the legend is, in pixels of the window from its lower left corner.
struct LegendPlace {
  double left = 0;
  double width = 0;
  double height = 0;  ///< of the window; the legend keeps its own margins
  double textSize = 0;
};

struct Tick {
  double value = 0;
  std::string text;
};

/// The smallest of 1, 2 and 5 times a power of ten that is no less than `least`.
[[nodiscard]] double roundStep(double least);

/// Round numbers on the scale, ascending, about five; powers of ten where it is logarithmic. Of a scale of bands where
/// two of them meet, and its ends, or evenly some of these.
[[nodiscard]] std::vector<Tick> ticksOf(const ColorScale& scale);

/// Adds the legend to a renderer that fills the window.
void addLegend(vtkRenderer& renderer, const LegendContents& contents, const LegendPlace& place);

}  // namespace holdfast
