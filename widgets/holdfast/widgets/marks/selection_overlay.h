#pragma once
/// Vertices that are selected, on the mesh that is drawn.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <holdfast/widgets/marks/face_tint.h>

namespace holdfast {

/// No more vertices than this are dotted, evenly spread.
inline constexpr Index kMostSelectionDots = 2000;

/// A tint with an outline over the triangles between them, and small dots on vertices without such a triangle.
class SelectionOverlay {
 public:
  /// Both stay alive as long as this.
  SelectionOverlay(const Model& model, const MeshActor& mesh);

  /// File vertices, in any order. Those that no face uses do not show. O(T).
  void set(const std::vector<Index>& fileVertices);

  /// Of what is drawn of the mesh now: after `MeshActor::setHidden`. O(T).
  void refresh();

  /// The diameter of dots, in pixels of the window.
  void setDotPixels(double pixels) { dots_->GetProperty()->SetPointSize(static_cast<float>(pixels)); }

  [[nodiscard]] vtkActor& dots() const { return *dots_; }
  [[nodiscard]] FaceTint& tint() { return tint_; }

 private:
  const Model& model_;
  const MeshActor& mesh_;
  std::vector<Index> selected_;
  vtkNew<vtkPolyData> dotData_;
  vtkNew<vtkActor> dots_;
  FaceTint tint_;
};

}  // namespace holdfast
