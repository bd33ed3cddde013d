#pragma once
/// The unit sphere on which rotations are shown: its shell, its rings of equal angles, and small shapes on it.

#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include <holdfast/base/types.h>
#include <holdfast/widgets/color/color_map.h>

class vtkPolyData;

namespace holdfast {

/// The name of a ring and its place.
struct RingName {
  std::string text;
  Vector3 place;
};

/// A closed surface a little within the unit sphere: what lies on the sphere is before it.
[[nodiscard]] vtkSmartPointer<vtkPolyData> sphereShell();

/// Rings of rotations by multiples of 45 degrees, whose quaternions lie half that from the pole +z, and meridians.
[[nodiscard]] vtkSmartPointer<vtkPolyData> sphereRings();

[[nodiscard]] std::vector<RingName> ringNames();

/// The colour that is `share` of the way from `from` to `to`.
[[nodiscard]] Color mixed(const Color& from, const Color& to, double share);

}  // namespace holdfast
