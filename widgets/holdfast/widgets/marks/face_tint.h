#pragma once
/// Some vertices of the mesh that is drawn as tinted faces with an outline.

#include <span>
#include <utility>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <holdfast/widgets/mesh/mesh_actor.h>

namespace holdfast {

/// A tint over the triangles between some vertices, with a line around it. Both share the points of the mesh.
class FaceTint {
 public:
  /// `mesh` stays alive as long as this.
  FaceTint(const MeshActor& mesh, const Color& color, double opacity = 0.45);

  /// Whether each file vertex is one of them; none where it is empty. O(T).
  void set(std::vector<char> isIn);
  /// Tints what is drawn of the mesh now; is called after `MeshActor::setHidden`. O(T).
  void refresh() { set(std::move(isIn_)); }
  /// Is called after `MeshActor::setDetail`: large tints are as coarse as the mesh.
  void updateDetail();
  void setPixelRatio(double ratio);

  [[nodiscard]] vtkActor& faces() const { return *faces_; }
  [[nodiscard]] std::vector<vtkActor*> outline() const { return {rim_, line_}; }
  /// The faces in full detail, a part at a time, until the next `updateDetail`.
  [[nodiscard]] ActorSlices& slices() { return slices_; }
  /// Whether a triangle at this file vertex is tinted.
  [[nodiscard]] bool covers(Index vertex) const { return !isCovered_.empty() && isCovered_[vertex] != 0; }

 private:
  [[nodiscard]] bool isBetween(std::span<const int> points, const std::vector<Index>& vertexOf) const;
  /// Finds the tinted triangles as well.
  void setOutline();

  const MeshActor& mesh_;
  std::vector<char> isIn_;       // of each file vertex
  std::vector<char> isTinted_;   // each triangle of the mesh; empty where none is
  std::vector<char> isCovered_;  // by tinted triangles; empty where there are none
  vtkIdType tinted_ = 0;         // of the triangles of the mesh
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPolyData> coarseData_;
  vtkNew<vtkPolyData> lineData_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkPolyDataMapper> coarseMapper_;
  vtkNew<PushedActor> faces_;
  vtkNew<BlendedActor> rim_;
  vtkNew<BlendedActor> line_;
  ActorSlices slices_{*faces_, *mapper_};
};

}  // namespace holdfast
