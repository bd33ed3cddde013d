#include "holdfast/widgets/scene/display_settings.h"

namespace holdfast {

void arrange(SceneContents& contents, const DisplaySettings& settings)
{
  contents.setRestGhost(settings.rest);
  contents.setMeshEdges(settings.edges);
  contents.setRotationDisplay(settings.rotations);
  if (!settings.areConstraintsShown) contents.setMarks({});
}

std::optional<Coloring> coloringOf(const Model& model, const DeformResult& deformation, const ColorSettings& settings,
                                   const std::string& units)
{
  std::optional<Coloring> coloring = coloringOf(model, deformation, settings.field, units);
  if (!coloring) return std::nullopt;
  coloring = withRange(std::move(*coloring), settings.range);
  coloring->scale.map = settings.map;
  return coloring;
}

}  // namespace holdfast
