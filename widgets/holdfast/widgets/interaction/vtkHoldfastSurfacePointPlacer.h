#pragma once
/// Places points of VTK's handles and contours on a surface.

#include <memory>
#include <optional>

#include <vtkPointPlacer.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Places points of VTK's handles and contours on a surface. The points are visible and in double precision. They have
/// the weights that a constraint there would have.
///
///     vtkNew<vtkHoldfastSurfacePointPlacer> placer;
///     placer->SetSurface(surface);
///     vtkNew<vtkPointHandleRepresentation3D> drawn;
///     drawn->SetPointPlacer(placer);
///     handle->SetRepresentation(drawn);  // a vtkHandleWidget
class vtkHoldfastSurfacePointPlacer : public vtkPointPlacer {
 public:
  static vtkHoldfastSurfacePointPlacer* New();
  vtkTypeMacro(vtkHoldfastSurfacePointPlacer, vtkPointPlacer)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the surface; with null, the default, there are no points. It may change at any time.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface)
  {
    holdfast::assign(*this, this->Surface, std::move(surface));
  }
  [[nodiscard]] const std::shared_ptr<const holdfast::VisibleSurface>& GetSurface() const { return this->Surface; }

  /// Sets what points may lie on; `Nearest` by default.
  vtkSetEnumMacro(Kind, holdfast::PickKind);
  [[nodiscard]] holdfast::PickKind GetKind() const { return this->Kind; }

  /// Sets how near to the cursor a vertex or an edge is taken, in pixels of a display of ordinary resolution. The
  /// default is 7.
  vtkSetClampMacro(SnapPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SnapPixels, double);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// Writes the point that a click on a pixel of the renderer's window means, as `SurfacePicker::pick` finds it, and
  /// returns true. Where there is none it returns false, and `pick` stays as it is.
  [[nodiscard]] bool Pick(vtkRenderer& renderer, const double displayPos[2], holdfast::SurfacePick& pick) const;

  /// Returns the last point that one of the functions below has placed; null before the first.
  [[nodiscard]] const holdfast::SurfacePick* GetLastPick() const { return this->LastPick ? &*this->LastPick : nullptr; }

  /// Writes the place of the point on the surface and returns 1, or returns 0 where there is no point. The orientation
  /// is the identity.
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double worldPos[3],
                           double worldOrient[9]) override;
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double* /*refWorldPos*/, double worldPos[3],
                           double worldOrient[9]) override
  {
    return this->ComputeWorldPosition(renderer, displayPos, worldPos, worldOrient);
  }
  /// Returns 1: what was placed once stays valid when the surface has moved on.
  int ValidateWorldPosition(double* /*worldPos*/) override { return 1; }
  int ValidateWorldPosition(double* /*worldPos*/, double* /*worldOrient*/) override { return 1; }

 protected:
  vtkHoldfastSurfacePointPlacer() = default;
  ~vtkHoldfastSurfacePointPlacer() override = default;

 private:
  std::shared_ptr<const holdfast::VisibleSurface> Surface;
  holdfast::PickKind Kind = holdfast::PickKind::Nearest;
  double SnapPixels = 7;
  double PixelRatio = 1;
  std::optional<holdfast::SurfacePick> LastPick;
};
