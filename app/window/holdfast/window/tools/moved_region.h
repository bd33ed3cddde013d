#pragma once
/// Shows handles of a large mesh where they are to be, while the rest of the mesh is still being solved.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <holdfast/numbers/types.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

/// The region is drawn over the picture, which is not drawn again for it. It is hidden until `moveTo`.
class MovedRegion {
 public:
  explicit MovedRegion(Viewport& viewport);

  /// Begins with the triangles between these vertices of the file. O(their triangles).
  void begin(const std::vector<Index>& vertices);
  /// Moves the vertices to `places`, which has one row for each of them, and shows the region.
  void moveTo(const Positions& places);
  void hide();
  [[nodiscard]] vtkPoints& points() { return *points_; }
  [[nodiscard]] bool isVisible() { return actor_->GetVisibility() != 0; }

 private:
  Viewport& viewport_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor> actor_;
};

}  // namespace holdfast
