#include "holdfast/constraints/point_tolerance.h"

#include <cmath>

#include <fmt/format.h>

namespace holdfast {
namespace {

using PossibleError = std::optional<ToleranceError>;

PossibleError errorUnlessAboveZero(const char* key, double value)
{
  if (value > 0 && std::isfinite(value)) return std::nullopt;
  return ToleranceError{key, fmt::format("it must be above 0, this is {}", value)};
}

struct ErrorOf {
  PossibleError operator()(const Exactly& /*exactly*/) const { return std::nullopt; }
  PossibleError operator()(const WithinBall& ball) const { return errorUnlessAboveZero(".within.ball", ball.radius); }
  PossibleError operator()(const WithinBox& box) const
  {
    for (const double half : box.half)
      if (PossibleError error = errorUnlessAboveZero(".within.box", half)) return error;
    return std::nullopt;
  }
  PossibleError operator()(const WithinSlab& slab) const
  {
    if (slab.normal.isZero(0)) return ToleranceError{".within.normal", "a direction cannot be zero in x, y and z"};
    if (!(slab.low < slab.high))
      return ToleranceError{
          ".within.slab",
          fmt::format(R"({} is not below {}; for a plane that is met exactly give "on")", slab.low, slab.high)};
    if (!std::isfinite(slab.low) && !std::isfinite(slab.high))
      return ToleranceError{".within.slab", "one of both bounds is needed"};
    return std::nullopt;
  }
  PossibleError operator()(const Weighted& weighted) const { return errorUnlessAboveZero(".weight", weighted.weight); }
};

}  // namespace

std::optional<ToleranceError> validateTolerance(const PointTolerance& tolerance)
{
  return std::visit(ErrorOf{}, tolerance);
}

}  // namespace holdfast
