#include "holdfast/window/model/at_rest.h"

namespace holdfast {

Vector3 requireRestPlace(const Editor& editor, const SurfaceLocation& location)
{
  return positionOf(editor.model()->locator().locate(location, {}), editor.model()->mesh.positions);
}

std::optional<Vector3> restPlace(const Editor& editor, const SurfaceLocation& location)
{
  if (!editor.isOpen()) return std::nullopt;
  try {
    return requireRestPlace(editor, location);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<Constraint> withTarget(Constraint constraint, const Vector3& target, const Editor& editor)
{
  if (!editor.isOpen() || !hasTarget(constraint)) return std::nullopt;
  try {
    setTarget(constraint, target, [&](const SurfaceLocation& at) { return requireRestPlace(editor, at); });
    return constraint;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

FoundVertices findVertices(const Editor& editor, const Selection& selection)
{
  try {
    return {editor.mesh().selector->select(selection, {}), {}};
  } catch (const InputError& error) {
    return {{}, error.reason()};
  }
}

}  // namespace holdfast
