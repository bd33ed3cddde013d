#include "holdfast/widgets/mesh/section_plane.h"

#include <algorithm>

namespace holdfast {

bool isKept(const SectionPlane& section, const Vector3& place)
{
  return (place - section.origin).dot(section.normal) >= 0;
}

RayRange keptPart(const SectionPlane& section, const Ray& ray, const RayRange& range)
{
  constexpr RayRange kNothing{1, 0};
  const double height = (ray.origin - section.origin).dot(section.normal);
  const double slope = ray.direction.dot(section.normal);
  if (slope == 0) return height >= 0 ? range : kNothing;
  const double crossing = -height / slope;
  if (slope > 0) return {std::max(range.begin, crossing), range.end};
  return {range.begin, std::min(range.end, crossing)};
}

}  // namespace holdfast
