#pragma once
/// \file
/// A plane that cuts away what lies on one side of it, so that the inside can be seen.

#include <holdfast/surface/ray_caster.h>

namespace holdfast {

/// What lies on the plane, or on the side that `normal` points to, is kept: as VTK's clipping planes do.
struct SectionPlane {
  Vector3 origin = Vector3::Zero();   ///< model units
  Vector3 normal = Vector3::UnitZ();  ///< not zero, of any length

  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

[[nodiscard]] bool isKept(const SectionPlane& section, const Vector3& place);

/// The part of a ray within `range` that is kept.
[[nodiscard]] RayRange keptPart(const SectionPlane& section, const Ray& ray, const RayRange& range);

}  // namespace holdfast
