#pragma once
/// A large mesh is drawn with fewer triangles while it moves.

#include <memory>
#include <vector>

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/mesh/shaded_surface.h>

namespace holdfast {

class AreaWeightedNormals;

/// About so many triangles of a moving mesh are drawn. Without a GPU that takes a few milliseconds.
inline constexpr Index kCoarseTriangles = 20'000;

/// Fewer triangles that stand for those of a surface.
struct CoarseTriangles {
  Polygons triangles;          ///< the triangles over points of the surface
  std::vector<Index> sources;  ///< for each of them, a triangle of the surface for which it stands
};

/// Chooses about `target` (larger than 0) triangles over points of `surface`, which was cut from `model`. Where the
/// surface has up to one and a half times as many, they are its own. Vertices that are near one another at rest and
/// face the same way are drawn as one of them. What moves the points therefore moves these triangles. They have no gaps
/// where the model has none. O(T log T).
[[nodiscard]] CoarseTriangles coarseTriangles(const Model& model, const ShadedSurface& surface, Index target);

/// About `kCoarseTriangles` triangles of a surface, over copies of the points that they need.
class CoarseSurface {
 public:
  /// Chooses the triangles at rest. O(T log T).
  CoarseSurface(const Model& model, const ShadedSurface& surface);
  ~CoarseSurface();

  /// Moves the triangles with the points of the surface. All triangles of the surface shape the normals.
  void follow(const Positions& places);
  /// Copies the shares of the scale at the points of the surface. Null means that the surface has one colour.
  void color(const vtkDoubleArray* shares);

  /// Leaves out the triangles that stand for hidden triangles of the surface. `isHidden` has one entry for each
  /// triangle of the surface. An empty vector leaves out none. O(coarse triangles).
  void setHidden(const std::vector<char>& isHidden);

  /// Returns the triangles that are drawn.
  [[nodiscard]] const Polygons& triangles() const noexcept { return drawn_; }
  /// Tells whether the triangles are the whole skin of a solid at rest. From outside only the fronts of its triangles
  /// are seen.
  [[nodiscard]] bool isSolid() const noexcept { return isSolid_ && drawn_.size() == triangles_.size(); }
  /// Tells whether the place is within the box around the points.
  [[nodiscard]] bool isNear(const Vector3& place) const;
  /// Returns the vertex of the file for each point.
  [[nodiscard]] const std::vector<Index>& vertexOf() const noexcept { return vertexOf_; }
  [[nodiscard]] vtkPolyData& data() const { return *data_; }

 private:
  Polygons triangles_;
  std::vector<Index> sources_;
  Polygons drawn_;
  bool isSolid_;
  std::vector<Index> pointOf_;  // the point of the surface, for each point
  std::vector<Index> vertexOf_;
  Polygons around_;                                     // the triangles of the surface at these points
  std::unique_ptr<AreaWeightedNormals> doubleNormals_;  // at these points
  vtkNew<vtkDoubleArray> places_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkPolyData> data_;
};

}  // namespace holdfast
