#include "holdfast/widgets/picking/screen_selection.h"

#include <algorithm>
#include <utility>

namespace holdfast {
namespace {

ScreenPolygon throughCenters(std::span<const DisplayPoint> pixels)
{
  std::vector<DisplayPoint> corners;
  for (const DisplayPoint& pixel : pixels) corners.push_back(centerOfPixel(pixel.x(), pixel.y()));
  return ScreenPolygon(corners);
}

}  // namespace

ScreenSelection::ScreenSelection(vtkRenderer& renderer, std::shared_ptr<const VisibleSurface> surface,
                                 std::span<const DisplayPoint> polygon, ScreenReach reach)
    : surface_(std::move(surface)), display_(renderer), outline_(throughCenters(polygon)), reach_(reach)
{
}

bool ScreenSelection::isInside(Index vertex) const
{
  const Vector3 place = surface_->positions().row(vertex);
  const DisplayTransform::Shown shown = display_.show(place);
  if (!(shown.depth > 0) || !display_.isInside(shown.point) || !outline_.contains(shown.point)) return false;
  if (surface_->trianglesAt(vertex).empty() || !surface_->isKept(place)) return false;
  return reach_ == ScreenReach::Through || surface_->isVertexVisible(vertex, display_);
}

void ScreenSelection::advance(Index count)
{
  const Index end = std::min(next_ + count, surface_->positions().rows());
  for (; next_ < end; ++next_)
    if (isInside(next_)) inside_.push_back(next_);
}

std::vector<Index> verticesInScreenPolygon(vtkRenderer& renderer, std::shared_ptr<const VisibleSurface> surface,
                                           std::span<const DisplayPoint> polygon, ScreenReach reach)
{
  const Index count = surface->positions().rows();
  ScreenSelection selection(renderer, std::move(surface), polygon, reach);
  selection.advance(count);
  return selection.inside();
}

}  // namespace holdfast
