#pragma once
/// \file
/// A user's choices about the display of a document. They do not change the document.

#include <holdfast/widgets/color/coloring.h>
#include <holdfast/widgets/scene/scene_contents.h>

namespace holdfast {

/// The field that colours the surface, and its scale.
struct ColorSettings {
  ColorBy field = ColorBy::Displacement;
  ColorRange range = AutomaticRange{};  ///< `whyNoRange` of it is empty
  ColorMap map = ColorMap::BlueGreenYellow;
};

/// The things beside the deformed surface.
struct DisplaySettings {
  RestGhost rest = RestGhost::Edges;
  MeshEdges edges = MeshEdges::Sharp;
  RotationDisplay rotations = RotationDisplay::Hidden;
  bool areConstraintsShown = true;

  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

/// Shows in `contents`, to which a deformation was shown, what `settings` say.
void arrange(SceneContents& contents, const DisplaySettings& settings);

/// The values of the chosen field on the chosen scale; none for `ColorBy::None`. `units` as in the function of the same
/// name.
[[nodiscard]] std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation,
                                                 const ColorSettings& settings, const std::string& units);

}  // namespace holdfast
