#pragma once
/// A surface beside the mesh on which constraints keep points: a scan, or another part.

#include <memory>
#include <string>
#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// The foot of a place is the place of a surface that is nearest to it.
struct Foot {
  Vector3 place = Vector3::Zero();
  /// The tangent plane at the foot is across this, of length 1. It goes smoothly from triangle to triangle, but not
  /// over creases.
  Vector3 normal = Vector3::UnitZ();
  double distance = 0;      ///< of the place, model units; below 0 where it lies behind the surface
  bool isOnBorder = false;  ///< on an edge of one triangle
};

/// A guide surface finds the feet of places. Its vertices that lie in one place are one, as those of STL files.
///
///     auto scan = std::make_shared<const GuideSurface>(readMesh("scan.stl").mesh, "scan.stl");
///     list.constraints.push_back({"top", true, SlideConstraint{top, OnMesh{"scan.stl", scan}}});
class GuideSurface {
 public:
  /// Triangles without area and those with coordinates that are not finite are left out. Throws `InputError` at
  /// `source` where none are left. O(T log T).
  GuideSurface(const Mesh& mesh, const std::string& source);
  ~GuideSurface();
  GuideSurface(const GuideSurface&) = delete;
  GuideSurface& operator=(const GuideSurface&) = delete;
  GuideSurface(GuideSurface&&) = delete;
  GuideSurface& operator=(GuideSurface&&) = delete;

  [[nodiscard]] const Positions& positions() const noexcept;
  [[nodiscard]] const std::vector<Triangle>& triangles() const noexcept;

  /// Returns the foot of a finite place. O(log T).
  [[nodiscard]] Foot footOf(const Vector3& place) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace holdfast
