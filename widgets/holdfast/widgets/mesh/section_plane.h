#pragma once
/// A section plane cuts away one side of the picture, so that the inside can be seen.

#include <holdfast/numbers/types.h>

namespace holdfast {

/// A plane that keeps what lies on it or on the side that `normal` points to, as VTK's clipping planes do.
struct SectionPlane {
  Vector3 origin = Vector3::Zero();   ///< model units
  Vector3 normal = Vector3::UnitZ();  ///< not zero, of any length

  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// Tells whether the plane keeps a place.
[[nodiscard]] inline bool isKept(const SectionPlane& section, const Vector3& place)
{
  return (place - section.origin).dot(section.normal) >= 0;
}

}  // namespace holdfast
