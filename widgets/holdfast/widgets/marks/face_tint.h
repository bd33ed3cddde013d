#pragma once
/// A tint shows some vertices of the mesh that is drawn as tinted faces with an outline.

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
///
///     FaceTint tint(mesh, Color{0.9, 0.5, 0.1});  // mesh: a MeshActor
///     tint.set(isIn);
///     renderer->AddActor(&tint.faces());
///     for (vtkActor* const actor : tint.outline()) renderer->AddActor(actor);
class FaceTint {
 public:
  /// Makes a tint without triangles. `mesh` must stay alive as long as the tint.
  FaceTint(const MeshActor& mesh, const Color& color, double opacity = 0.45);

  /// Tints the triangles whose vertices are all in the set. `isIn` says for each vertex of the file whether it is in
  /// it. An empty vector means none. O(T).
  void set(std::vector<char> isIn);
  /// Tints what is drawn of the mesh now. Call it after `MeshActor::setHidden`. O(T).
  void refresh() { set(std::move(isIn_)); }
  /// Makes a large tint as coarse as the mesh. Call it after `MeshActor::setDetail`.
  void updateDetail();
  /// Sets how many pixels of the window are one of the picture. Widths of lines are in pixels of the picture.
  void setPixelRatio(double ratio);

  [[nodiscard]] vtkActor& faces() const { return *faces_; }
  [[nodiscard]] std::vector<vtkActor*> outline() const { return {rim_, line_}; }
  /// Returns the faces in full detail, to be drawn a part at a time until the next `updateDetail`.
  [[nodiscard]] ActorSlices& slices() { return slices_; }
  /// Tells whether a triangle at this vertex of the file is tinted.
  [[nodiscard]] bool covers(Index vertex) const { return !isCovered_.empty() && isCovered_[vertex] != 0; }

 private:
  [[nodiscard]] bool isBetween(std::span<const int> points, const std::vector<Index>& vertexOf) const;
  /// Finds the tinted triangles as well.
  void setOutline();

  const MeshActor& mesh_;
  std::vector<char> isIn_;       // one for each vertex of the file
  std::vector<char> isTinted_;   // one for each triangle of the mesh; empty where none is tinted
  std::vector<char> isCovered_;  // one for each vertex of the file: a tinted triangle is at it; empty where none is
  vtkIdType tinted_ = 0;         // the number of tinted triangles of the mesh
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
