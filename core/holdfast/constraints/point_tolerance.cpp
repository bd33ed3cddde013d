#include "holdfast/constraints/point_tolerance.h"

#include <cmath>

#include <fmt/format.h>

namespace holdfast {
namespace {

using ToleranceFault = std::optional<ToleranceError>;

ToleranceFault errorUnlessAboveZero(const char* key, double value)
{
  if (value > 0 && std::isfinite(value)) return std::nullopt;
  return ToleranceError{key, fmt::format("it must be above 0, this is {}", value)};
}

struct ErrorOf {
  const RowDirections& directions;

  ToleranceFault operator()(const Exactly& /*exactly*/) const { return std::nullopt; }
  ToleranceFault operator()(const WithinBall& ball) const { return errorUnlessAboveZero(".within.ball", ball.radius); }
  ToleranceFault operator()(const WithinBox& box) const
  {
    if (!directions.areAll())
      return ToleranceError{".within.box", R"(only a point that goes to one place is within a box; give a "ball")"};
    for (const double half : box.half)
      if (ToleranceFault error = errorUnlessAboveZero(".within.box", half)) return error;
    return std::nullopt;
  }
  ToleranceFault operator()(const WithinSlab& slab) const
  {
    if (ToleranceFault error = errorOfNormal(slab.normal)) return error;
    if (!(slab.low < slab.high))
      return ToleranceError{
          ".within.slab",
          fmt::format(R"({} is not below {}; for a plane that is met exactly give "on")", slab.low, slab.high)};
    if (!std::isfinite(slab.low) && !std::isfinite(slab.high))
      return ToleranceError{".within.slab", "one of both bounds is needed"};
    return std::nullopt;
  }
  ToleranceFault operator()(const Weighted& weighted) const { return errorUnlessAboveZero(".weight", weighted.weight); }

 private:
  [[nodiscard]] ToleranceFault errorOfNormal(const std::optional<Vector3>& normal) const
  {
    if (!directions.areAll() && !directions.areAlongAxis())
      return ToleranceError{".within.slab", R"(a point on a line lies in no slab; give a "ball" around the line)"};
    if (!directions.areAll() && normal)
      return ToleranceError{".within.normal", "the slab lies along the plane or the surface; leave its normal out"};
    if (directions.areAll() && !normal) return ToleranceError{".within", R"(the slab needs a "normal"; add one)"};
    if (normal && normal->isZero(0))
      return ToleranceError{".within.normal", "a direction cannot be zero in x, y and z"};
    return std::nullopt;
  }
};

}  // namespace

std::optional<ToleranceError> validateTolerance(const PointTolerance& tolerance, const RowDirections& directions)
{
  return std::visit(ErrorOf{directions}, tolerance);
}

}  // namespace holdfast
