#include "holdfast/constraints/constraint.h"

#include <algorithm>

#include <holdfast/numbers/same_bits.h>
#include <holdfast/surface/guide_surface.h>

namespace holdfast {

namespace {

using Goal = decltype(PointConstraint::to);

Goal moved(const Target& /*target*/, const Vector3& place, const Vector3& /*rest*/)
{
  return Target{place};
}

Goal moved(const Move& move, const Vector3& place, const Vector3& rest)
{
  Vector3 shift = move.shift;
  for (Index k = 0; k < 3; ++k) {
    if (!hasSameBits(rest[k] + shift[k], place[k])) shift[k] = place[k] - rest[k];
    if (!hasSameBits(rest[k] + shift[k], place[k])) return Target{place};
  }
  return Move{shift};
}

Goal moved(Coordinates coordinates, const Vector3& place, const Vector3& /*rest*/)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (coordinates.values[k]) coordinates.values[k] = place[static_cast<Index>(k)];
  return coordinates;
}

Goal moved(const OnPlane& plane, const Vector3& place, const Vector3& /*rest*/)
{
  return OnPlane{place, plane.normal, 0};
}

Goal moved(const OnLine& line, const Vector3& place, const Vector3& /*rest*/)
{
  return OnLine{place, line.direction};
}

Goal moved(const OnMesh& surface, const Vector3& /*place*/, const Vector3& /*rest*/)
{
  return surface;
}

/// Returns `place` with the coordinates of `exact` that `directions` hold by themselves.
Vector3 withCoordinates(Vector3 place, const RowDirections& directions, const Vector3& exact)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (directions.coordinates()[k]) place[static_cast<Index>(k)] = exact[static_cast<Index>(k)];
  return place;
}

}  // namespace

Vector3 Coordinates::placeFrom(const Vector3& rest) const
{
  Vector3 place = rest;
  for (std::size_t k = 0; k < 3; ++k)
    if (values[k]) place[static_cast<Index>(k)] = *values[k];
  return place;
}

RowDirections Coordinates::directions() const
{
  const auto isGiven = [](const std::optional<double>& value) { return value.has_value(); };
  const auto count = std::ranges::count_if(values, isGiven);
  if (count == 1) return RowDirections::along(Vector3::Unit(std::ranges::find_if(values, isGiven) - values.begin()));
  if (count == 2)
    return RowDirections::across(Vector3::Unit(std::ranges::find_if_not(values, isGiven) - values.begin()));
  return {};
}

Vector3 OnPlane::shiftFrom(const Vector3& rest) const
{
  const Vector3 n = normal.stableNormalized();
  return (offset + (point ? n.dot(*point - rest) : 0)) * n;
}

Vector3 OnPlane::placeFrom(const Vector3& rest) const
{
  const RowDirections held = directions();
  return withCoordinates(rest + shiftFrom(rest), held, point.value_or(rest) + offset * held.axis());
}

Vector3 OnLine::placeFrom(const Vector3& rest) const
{
  return withCoordinates(rest + shiftFrom(rest), directions(), point.value_or(rest));
}

Vector3 OnLine::shiftFrom(const Vector3& rest) const
{
  return point ? directions().held(*point - rest) : Vector3::Zero();
}

Vector3 OnMesh::placeFrom(const Vector3& rest) const
{
  return surface == nullptr ? rest : surface->footOf(rest).place;
}

void PointConstraint::setTarget(const Vector3& place, const RestPlace& restPlace)
{
  const Vector3 rest = restPlace(at);
  to = std::visit([&](const auto& its) { return moved(its, place, rest); }, to);
}

OnMesh* guideMeshOf(Constraint& constraint)
{
  if (auto* point = std::get_if<PointConstraint>(&constraint.what)) return std::get_if<OnMesh>(&point->to);
  auto* slide = std::get_if<SlideConstraint>(&constraint.what);
  return slide == nullptr ? nullptr : std::get_if<OnMesh>(&slide->on);
}

std::vector<SurfaceLocation> placesOf(const Constraint& constraint)
{
  return std::visit(
      [](const auto& what) -> std::vector<SurfaceLocation> {
        if constexpr (requires { what.places(); })
          return what.places();
        else
          return {};
      },
      constraint.what);
}

bool hasTarget(const Constraint& constraint)
{
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.hasTarget(); })
          return what.hasTarget();
        else
          return false;
      },
      constraint.what);
}

void setTarget(Constraint& constraint, const Vector3& target, const RestPlace& restPlace)
{
  std::visit(
      [&](auto& what) {
        if constexpr (requires { what.hasTarget(); })
          if (what.hasTarget()) what.setTarget(target, restPlace);
      },
      constraint.what);
}

}  // namespace holdfast
