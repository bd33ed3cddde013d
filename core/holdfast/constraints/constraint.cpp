#include "holdfast/constraints/constraint.h"

#include <holdfast/numbers/same_bits.h>

namespace holdfast {

void PointConstraint::setTarget(const Vector3& place, const RestPlace& restPlace)
{
  const Vector3 rest = restPlace(at);
  Move* const move = std::get_if<Move>(&to);
  bool isShift = move != nullptr;
  Vector3 shift = isShift ? move->shift : Vector3::Zero();
  for (Index k = 0; k < 3; ++k) {
    if (!hasSameBits(rest[k] + shift[k], place[k])) shift[k] = place[k] - rest[k];
    isShift = isShift && hasSameBits(rest[k] + shift[k], place[k]);
  }
  if (isShift)
    to = Move{shift};
  else
    to = Target{place};
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
