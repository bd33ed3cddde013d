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

Vector3 placeOf(const PointConstraint& point, const Vector3& rest)
{
  if (const Target* target = std::get_if<Target>(&point.to)) return target->place;
  return rest + std::get<Move>(point.to).shift;
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

const Selection* selectionOf(const Constraint& constraint)
{
  return std::visit(
      [](const auto& what) -> const Selection* {
        if constexpr (requires { what.select; })
          return &what.select;
        else
          return nullptr;
      },
      constraint.what);
}

}  // namespace holdfast
