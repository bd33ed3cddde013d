#pragma once
/// \file
/// All of a `ScreenSelection` at once.

#include <holdfast/widgets/picking/screen_selection.h>

namespace holdfast::test {

[[nodiscard]] inline std::vector<Index> verticesInScreenPolygon(vtkRenderer& renderer,
                                                                const std::shared_ptr<const VisibleSurface>& surface,
                                                                std::span<const DisplayPoint> polygon,
                                                                ScreenReach reach)
{
  ScreenSelection selection(renderer, surface, polygon, reach);
  selection.advance(surface->positions().rows());
  return selection.inside();
}

}  // namespace holdfast::test
