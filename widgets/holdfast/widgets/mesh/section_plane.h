#pragma once
/// A plane that cuts away one side, so that the inside can be seen.

#include <holdfast/base/types.h>

namespace holdfast {

/// Keeps what is on the plane or on the side that `normal` points to, as VTK's clipping planes do.
struct SectionPlane {
  Vector3 origin = Vector3::Zero();   ///< model units
  Vector3 normal = Vector3::UnitZ();  ///< not zero, of any length

  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

[[nodiscard]] inline bool isKept(const SectionPlane& section, const Vector3& place)
{
  return (place - section.origin).dot(section.normal) >= 0;
}

}  // namespace holdfast
