#pragma once
/// \file
/// A handle that stays at its location on a surface.

#include <optional>

#include <vtkPointHandleRepresentation2D.h>

#include <holdfast/widgets/picking/surface_picker.h>

namespace holdfast {

/// A place on a surface, as it was named and as it is computed with.
struct SurfacePlacement {
  SurfaceLocation location;
  SurfacePoint point;
};

/// Placed by a `SurfacePointPlacer`, it remembers where on the surface it is: `FollowSurface` takes it there again when
/// the surface has moved. Beside the surface it stays where it was.
class SurfaceHandleRepresentation : public vtkPointHandleRepresentation2D {
 public:
  static SurfaceHandleRepresentation* New();
  vtkTypeMacro(SurfaceHandleRepresentation, vtkPointHandleRepresentation2D)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// None before it is placed. What it has been given can be set again.
  [[nodiscard]] const std::optional<SurfacePlacement>& GetPlacement() const { return this->Placement; }
  void SetPlacement(std::optional<SurfacePlacement> placement);

  /// Places it on the placer's surface. Throws `InputError` for a location that the mesh does not have. O(T log T).
  void SetLocation(const SurfaceLocation& location);

  /// To be called when the placer has another surface of the same mesh.
  void FollowSurface();

  /// Where it is at rest, model units. It is placed.
  [[nodiscard]] Vector3 GetRestPlace() const;
  /// Where it is now.
  [[nodiscard]] Vector3 GetPlace() const;

  void SetDisplayPosition(double display[3]) override;

 protected:
  SurfaceHandleRepresentation() = default;
  ~SurfaceHandleRepresentation() override = default;

 private:
  SurfaceHandleRepresentation(const SurfaceHandleRepresentation&) = delete;
  void operator=(const SurfaceHandleRepresentation&) = delete;

  [[nodiscard]] const VisibleSurface* GetSurface() const;

  std::optional<SurfacePlacement> Placement;
};

}  // namespace holdfast
