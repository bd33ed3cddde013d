#pragma once
/// \file
/// Places points on a surface: on its vertices, its edges or in its faces.

#include <memory>
#include <optional>

#include <vtkPointPlacer.h>

#include <holdfast/widgets/picking/surface_picker.h>

namespace holdfast {

/// A placer for VTK's handles and contours, and for the widgets of this room. Points that it gives are visible, in
/// double precision, and have the weights that a constraint there would have.
class SurfacePointPlacer : public vtkPointPlacer {
 public:
  static SurfacePointPlacer* New();
  vtkTypeMacro(SurfacePointPlacer, vtkPointPlacer)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What points are placed on; null (the default): nothing. May change at any time.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface);
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  /// What a point may lie on; `Nearest` by default.
  void SetKind(PickKind kind);
  [[nodiscard]] PickKind GetKind() const { return this->Kind; }

  /// How near the cursor a vertex or an edge is taken, pixels of a display of ordinary resolution; 7 by default.
  vtkSetClampMacro(SnapPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SnapPixels, double);
  /// Pixels of the window for each of such a display; 1 by default.
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// The point that a click on a pixel of the renderer's window means; none beside the surface. As
  /// `SurfacePicker::pick`.
  [[nodiscard]] std::optional<SurfacePick> Pick(vtkRenderer& renderer, const double displayPos[2]) const;

  /// The last point that one of the functions below has placed; none before the first.
  [[nodiscard]] const std::optional<SurfacePick>& GetLastPick() const { return this->LastPick; }

  /// 1 and the place of the point on the surface, or 0. The orientation is the identity.
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double worldPos[3],
                           double worldOrient[9]) override;
  int ComputeWorldPosition(vtkRenderer* renderer, double displayPos[2], double refWorldPos[3], double worldPos[3],
                           double worldOrient[9]) override;
  /// 1: what was placed once stays valid when the surface has moved on.
  int ValidateWorldPosition(double worldPos[3]) override;
  int ValidateWorldPosition(double worldPos[3], double worldOrient[9]) override;

 protected:
  SurfacePointPlacer() = default;
  ~SurfacePointPlacer() override = default;

 private:
  SurfacePointPlacer(const SurfacePointPlacer&) = delete;
  void operator=(const SurfacePointPlacer&) = delete;

  std::shared_ptr<const VisibleSurface> Surface;
  PickKind Kind = PickKind::Nearest;
  double SnapPixels = 7;
  double PixelRatio = 1;
  std::optional<SurfacePick> LastPick;
};

}  // namespace holdfast
