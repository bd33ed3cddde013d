#include <holdfast/view/display_settings.h>

namespace holdfast {

std::optional<Coloring> coloringOf(const Model& model, const Deformation& deformation, const ColorSettings& settings,
                                   const std::string& units)
{
  std::optional<Coloring> coloring = coloringOf(model, deformation, settings.field, units);
  if (!coloring) return std::nullopt;
  coloring = withRange(std::move(*coloring), settings.range);
  coloring->scale.map = settings.map;
  return coloring;
}

}  // namespace holdfast
