#pragma once
/// \file
/// VTK's plane with handles, for a plane that cuts a surface open.

#include <memory>
#include <utility>

#include <vtkImplicitPlaneRepresentation.h>

#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// As VTK's, but the plane itself takes the mouse only beside the surface, so that the user can pick behind a cut. Its
/// arrow and the ball in its middle take the mouse everywhere.
class SectionPlaneRepresentation : public vtkImplicitPlaneRepresentation {
 public:
  static SectionPlaneRepresentation* New();
  vtkTypeMacro(SectionPlaneRepresentation, vtkImplicitPlaneRepresentation)

  /// The part that is kept; null (the default): none.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Surface = std::move(surface); }

  int ComputeInteractionState(int x, int y, int modify = 0) override;

 protected:
  SectionPlaneRepresentation() = default;
  ~SectionPlaneRepresentation() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
};

}  // namespace holdfast
