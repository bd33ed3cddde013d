#include "holdfast/window/model/field_value.h"

#include <variant>

namespace holdfast {

double fieldValue(const Editor& editor, const Coloring& coloring, const SurfaceLocation& location)
{
  const Model& model = *editor.model();
  const auto* const inFace = std::get_if<AtFace>(&location);
  if (inFace == nullptr || coloring.pointValues.empty()) return valueAt(coloring.values, pointOf(location, model.mesh));
  return valueInFace(coloring.pointValues, *inFace, model, cutSurfaceOf(*editor.mesh().contents->mesh().shaded()));
}

}  // namespace holdfast
