#pragma once
/// An overlay shows the selected vertices on the mesh that is drawn.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <holdfast/widgets/marks/face_tint.h>

namespace holdfast {

/// No more vertices than this have dots. They are evenly spread.
inline constexpr Index kMostSelectionDots = 2000;

/// The look of selected vertices. A tint with an outline lies over the triangles between them. Small dots lie on
/// vertices without such a triangle.
class SelectionOverlay {
 public:
  /// Makes an overlay without vertices. `model` and `mesh` must stay alive as long as the overlay.
  SelectionOverlay(const Model& model, const MeshActor& mesh);

  /// Selects these vertices of the file, in any order. Vertices that no face uses are not shown. O(T).
  void set(const std::vector<Index>& fileVertices);

  /// Shows the selection on what is drawn of the mesh now. Call it after `MeshActor::setHidden`. O(T).
  void refresh();

  /// Sets the diameter of dots, in pixels of the window.
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
