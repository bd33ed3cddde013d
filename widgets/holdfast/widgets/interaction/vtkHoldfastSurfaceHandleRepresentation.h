#pragma once
/// Keeps a handle of VTK's on a surface.

#include <optional>

#include <vtkPointHandleRepresentation2D.h>

#include <holdfast/surface/surface_location.h>
#include <holdfast/surface/surface_point.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// A place on a surface: as it was named, and as the program computes with it.
struct SurfacePlacement {
  SurfaceLocation location;
  SurfacePoint point;
};

}  // namespace holdfast

/// A handle that keeps its location on the surface. A `vtkHoldfastSurfacePointPlacer` places it. Beside the surface it
/// stays where it was.
///
///     vtkNew<vtkHoldfastSurfaceHandleRepresentation> drawn;
///     drawn->SetPointPlacer(placer);  // a `vtkHoldfastSurfacePointPlacer` that has a surface
///     drawn->SetLocation(AtVertex{0});
///     handle->SetRepresentation(drawn);  // a vtkHandleWidget
class vtkHoldfastSurfaceHandleRepresentation : public vtkPointHandleRepresentation2D {
 public:
  static vtkHoldfastSurfaceHandleRepresentation* New();
  vtkTypeMacro(vtkHoldfastSurfaceHandleRepresentation, vtkPointHandleRepresentation2D)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Returns where the handle is; null before it is placed. `SetPlacement` copies; with null it makes the handle one
  /// that is not placed.
  [[nodiscard]] const holdfast::SurfacePlacement* GetPlacement() const
  {
    return this->Placement ? &*this->Placement : nullptr;
  }
  void SetPlacement(const holdfast::SurfacePlacement* placement);

  /// `PlacementAt` finds a location on the placer's surface, and `SetLocation` places the handle there. The placer has
  /// a surface. Both throw `InputError` for a location that the mesh does not have. O(T log T).
  [[nodiscard]] holdfast::SurfacePlacement PlacementAt(const holdfast::SurfaceLocation& location) const;
  void SetLocation(const holdfast::SurfaceLocation& location);

  /// Moves the handle with the surface. Call it when the placer has another surface of the same mesh.
  void FollowSurface();

  /// Return the handle's place at rest and its place now, in model units. The handle is placed.
  [[nodiscard]] holdfast::Vector3 GetRestPlace() const
  {
    return holdfast::positionOf(this->Placement->point, this->GetSurface()->model().mesh.positions);
  }
  [[nodiscard]] holdfast::Vector3 GetPlace() const
  {
    return holdfast::positionOf(this->Placement->point, this->GetSurface()->positions());
  }

  void SetDisplayPosition(double display[3]) override;

 protected:
  vtkHoldfastSurfaceHandleRepresentation() = default;
  ~vtkHoldfastSurfaceHandleRepresentation() override = default;

 private:
  [[nodiscard]] const holdfast::VisibleSurface* GetSurface() const;

  std::optional<holdfast::SurfacePlacement> Placement;
};
