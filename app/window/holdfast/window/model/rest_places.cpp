#include "holdfast/window/model/rest_places.h"

#include <holdfast/io/text/number_text.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

std::optional<Vector3> RestPlaces::of(const SurfaceLocation& location) const
{
  if (!editor_.isOpen()) return std::nullopt;
  try {
    return require(location);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Vector3 RestPlaces::require(const SurfaceLocation& location) const
{
  return positionOf(editor_.model()->locator().locate(location, {}).point, editor_.model()->mesh.positions);
}

SurfaceLocation RestPlaces::converted(const SurfaceLocation& location, LocationKind kind) const
{
  return holdfast::converted(location, kind, editor_.model()->mesh, editor_.model()->locator());
}

Vector3 placeOf(const PointConstraint& point, const Vector3& rest)
{
  if (const Target* target = std::get_if<Target>(&point.to)) return target->place;
  return rest + std::get<Move>(point.to).shift;
}

PointConstraint goingTo(PointConstraint point, const Vector3& rest, const Vector3& place)
{
  const Move* move = std::get_if<Move>(&point.to);
  if (move == nullptr) {
    point.to = Target{place};
    return point;
  }
  Vector3 shift = move->shift;
  for (Index k = 0; k < 3; ++k) {
    if (hasSameBits(rest[k] + shift[k], place[k])) continue;
    shift[k] = place[k] - rest[k];
    if (!hasSameBits(rest[k] + shift[k], place[k])) {
      point.to = Target{place};
      return point;
    }
  }
  point.to = Move{shift};
  return point;
}

}  // namespace holdfast
