#pragma once
/// Handles of a large mesh where they are to be, while the rest of it is still being solved.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <holdfast/base/types.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

/// Drawn over the picture, which is not drawn again for it. Hidden until `moveTo`.
class MovedRegion {
 public:
  explicit MovedRegion(Viewport& viewport);

  /// The triangles between these vertices of the file. O(their triangles).
  void begin(const std::vector<Index>& vertices);
  /// One row for each vertex.
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
