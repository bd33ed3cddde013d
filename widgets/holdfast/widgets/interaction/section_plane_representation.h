#pragma once
/// \file
/// VTK's plane with handles, for a plane that cuts a surface open.

#include <memory>
#include <utility>

#include <vtkImplicitPlaneRepresentation.h>

#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// As VTK's, but the plane itself takes the mouse only beside the surface: it lies before all that can be picked behind
/// a cut, which is why the user cuts. Its arrow and the ball in its middle take the mouse everywhere.
class SectionPlaneRepresentation : public vtkImplicitPlaneRepresentation {
 public:
  static SectionPlaneRepresentation* New();
  vtkTypeMacro(SectionPlaneRepresentation, vtkImplicitPlaneRepresentation)

  /// What is cut, without what is cut away; null (the default): nothing.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Surface = std::move(surface); }

  int ComputeInteractionState(int x, int y, int modify = 0) override;

 protected:
  SectionPlaneRepresentation() = default;
  ~SectionPlaneRepresentation() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
};

}  // namespace holdfast
