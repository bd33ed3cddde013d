#pragma once
/// Vertices that are selected, on the mesh that is drawn.

#include <algorithm>
#include <span>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/widgets/mesh/mesh_actor.h>

namespace holdfast {

/// No more vertices than this are dotted, evenly spread; the tint shows them all.
inline constexpr Index kMostSelectionDots = 2000;

/// Small dots on vertices, and a tint over the triangles between them; they share the points of the mesh.
class SelectionOverlay {
 public:
  /// Both stay alive as long as this.
  SelectionOverlay(const Model& model, const MeshActor& mesh);

  /// File vertices, in any order. Those that no face uses do not show. O(T).
  void set(const std::vector<Index>& fileVertices);
  /// That of the tint, where it covers many triangles.
  void setDetail(Detail detail);

  /// The diameter of dots, in pixels of the window.
  void setDotPixels(double pixels) { dots_->GetProperty()->SetPointSize(static_cast<float>(pixels)); }

  [[nodiscard]] vtkActor& dots() const { return *dots_; }
  [[nodiscard]] vtkActor& tint() const { return *tint_; }
  /// The tint in full detail, a part at a time, until the next `setDetail`.
  [[nodiscard]] ActorSlices& tintSlices() { return tintSlices_; }

 private:
  [[nodiscard]] bool areSelected(std::span<const Index> points, const std::vector<Index>& vertexOf) const
  {
    return std::ranges::all_of(points, [&](Index point) { return isSelected_[vertexOf[point]] != 0; });
  }
  [[nodiscard]] vtkIdType tintedOf(const Polygons& triangles, const std::vector<Index>& vertexOf) const;
  void setTint(vtkPolyData& data, const Polygons& triangles, const std::vector<Index>& vertexOf) const;
  void updateTint();

  const Model& model_;
  const MeshActor& mesh_;
  std::vector<Index> pointOf_;    // of each file vertex, -1 where no face uses it
  std::vector<char> isSelected_;  // of each file vertex
  Detail detail_ = Detail::Full;
  vtkIdType tinted_ = 0;  // of the triangles of the mesh
  vtkNew<vtkPolyData> dotData_;
  vtkNew<vtkPolyData> tintData_;
  vtkNew<vtkPolyData> coarseTintData_;
  vtkNew<vtkPolyDataMapper> tintMapper_;
  vtkNew<vtkPolyDataMapper> coarseTintMapper_;
  vtkNew<vtkActor> dots_;
  vtkNew<vtkActor> tint_;
  ActorSlices tintSlices_{*tint_, *tintMapper_};
};

}  // namespace holdfast
