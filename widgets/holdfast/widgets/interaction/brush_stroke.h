#pragma once
/// \file
/// The vertices that a brush touches on its way over the surface.

#include <memory>
#include <vector>

#include <holdfast/surface/vertex_regions.h>
#include <holdfast/widgets/picking/surface_picker.h>

namespace holdfast {

/// One stroke. Dabs of it are balls around places of the surface, of a radius that is seen as so many pixels there, and
/// reach along edges only (`VertexRegions::within`), and nothing that a section cuts away.
class BrushStroke {
 public:
  /// `regions` is not null, and made of the mesh whose surfaces `paintTo` gets.
  explicit BrushStroke(std::shared_ptr<VertexRegions> regions) : regions_(std::move(regions)) {}

  /// Paints from where the brush was to `pixel` in dabs 0.4 radii apart, the first time there alone. Places beside the
  /// surface get no dab. Whether the last of the dabs was on the surface.
  bool paintTo(const DisplayPoint& pixel, double radiusPixels, const std::shared_ptr<const VisibleSurface>& surface,
               vtkRenderer& renderer);

  /// Vertices of the file, ascending.
  [[nodiscard]] const std::vector<Index>& reached() const noexcept { return reached_; }

 private:
  bool dab(const DisplayPoint& pixel, double radiusPixels, const SurfacePicker& picker, vtkRenderer& renderer);

  std::shared_ptr<VertexRegions> regions_;
  std::optional<DisplayPoint> at_;  // none before the first dab
  std::vector<Index> reached_;
};

}  // namespace holdfast
