#pragma once
/// Shows the surfaces on which constraints keep points.

#include <memory>
#include <vector>

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/surface/guide_surface.h>
#include <holdfast/widgets/mesh/actors.h>

namespace holdfast {

/// A guide actor draws all of these surfaces translucent. It is hidden where there are none.
class GuideActor {
 public:
  /// Makes an actor that is cut by `sectionPlanes`.
  explicit GuideActor(vtkPlaneCollection& sectionPlanes);

  /// Shows these surfaces, none of them null. O(T) where they are others than before.
  void show(std::vector<std::shared_ptr<const GuideSurface>> surfaces);

  [[nodiscard]] vtkActor& actor() const { return *actor_; }

 private:
  std::vector<std::shared_ptr<const GuideSurface>> surfaces_;
  vtkNew<vtkPolyData> data_;
  vtkNew<BlendedActor> actor_;
};

}  // namespace holdfast
