#include "holdfast/window/model/at_rest.h"

#include <holdfast/io/text/number_text.h>

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

PointConstraint goingTo(PointConstraint point, const Vector3& rest, const Vector3& place)
{
  const Move* move = std::get_if<Move>(&point.to);
  Vector3 shift = move != nullptr ? move->shift : Vector3::Zero();
  bool isShift = move != nullptr;
  for (Index k = 0; k < 3; ++k) {
    if (!hasSameBits(rest[k] + shift[k], place[k])) shift[k] = place[k] - rest[k];
    isShift = isShift && hasSameBits(rest[k] + shift[k], place[k]);
  }
  if (isShift)
    point.to = Move{shift};
  else
    point.to = Target{place};
  return point;
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
