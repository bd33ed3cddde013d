#pragma once
/// A large mesh as it is drawn while it moves: fewer triangles.

#include <memory>
#include <vector>

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/widgets/mesh/shaded_surface.h>

namespace holdfast {

class AreaWeightedNormals;

/// About so many triangles of a moving mesh are drawn. Without a GPU it takes a few milliseconds.
inline constexpr Index kCoarseTriangles = 20'000;

struct CoarseTriangles {
  Polygons triangles;          ///< over points of a surface
  std::vector<Index> sources;  ///< of each: a triangle of the surface for which it stands
};

/// About `target` (larger than 0) triangles over points of `surface`, which was cut from `model`; its own where it has
/// up to one and a half times as many. Vertices near one another at rest that face the same way are drawn as one of
/// them, so that what moves the points moves these triangles. Without gaps where the model has none. O(T log T).
[[nodiscard]] CoarseTriangles coarseTriangles(const Model& model, const ShadedSurface& surface, Index target);

/// About `kCoarseTriangles` of a surface, over copies of the points that they need.
class CoarseSurface {
 public:
  /// O(T log T).
  CoarseSurface(const Model& model, const ShadedSurface& surface);
  ~CoarseSurface();

  /// Moves it with the points of the surface, of which all triangles shape its normals.
  void follow(const Positions& places);
  /// Copies the shares of the surface's points; null where it has one colour.
  void color(const vtkDoubleArray* shares);

  /// Leaves out those that stand for triangles of the surface for which `isHidden`, one for each; empty: none. O(their
  /// number).
  void setHidden(const std::vector<char>& isHidden);

  /// Those that are drawn.
  [[nodiscard]] const Polygons& triangles() const noexcept { return drawn_; }
  /// Whether it is drawn as the whole skin of a solid at rest: from outside only fronts of triangles are seen.
  [[nodiscard]] bool isSolid() const noexcept { return isSolid_ && drawn_.size() == triangles_.size(); }
  /// Whether the place is within the box around its points.
  [[nodiscard]] bool isNear(const Vector3& place) const;
  /// The file's vertex of each point.
  [[nodiscard]] const std::vector<Index>& vertexOf() const noexcept { return vertexOf_; }
  [[nodiscard]] vtkPolyData& data() const { return *data_; }

 private:
  Polygons triangles_;
  std::vector<Index> sources_;
  Polygons drawn_;
  bool isSolid_;
  std::vector<Index> pointOf_;  // of the surface, for each point
  std::vector<Index> vertexOf_;
  Polygons around_;                                     // the triangles of the surface at these points
  std::unique_ptr<AreaWeightedNormals> doubleNormals_;  // at these points
  vtkNew<vtkDoubleArray> places_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkPolyData> data_;
};

}  // namespace holdfast
