#include "holdfast/widgets/camera/seen_rotation.h"

#include <cmath>

#include <holdfast/geometry/degree.h>

namespace holdfast {
namespace {

// Nearer to the center on the display a place has no direction from it, pixels.
constexpr double kNoDirection = 1;

}  // namespace

double degreesSeen(const ViewGeometry& view, const Vector3& center, const Vector3& from, const Vector3& to, double near)
{
  const auto middle = toDisplay(view, center);
  const auto first = toDisplay(view, from);
  const auto last = toDisplay(view, to);
  if (!middle || !first || !last) return near;
  const DisplayPoint a = *first - *middle;
  const DisplayPoint b = *last - *middle;
  if (!(a.norm() > kNoDirection && b.norm() > kNoDirection)) return near;
  const double degrees = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / kDegree;
  return degrees + 360 * std::round((near - degrees) / 360);
}

}  // namespace holdfast
