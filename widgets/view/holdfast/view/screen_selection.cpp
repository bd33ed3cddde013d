
#include <holdfast/view/screen_polygon.h>
#include <holdfast/view/screen_selection.h>

namespace holdfast {
namespace {

ScreenPolygon throughCenters(std::span<const DisplayPoint> pixels)
{
  std::vector<DisplayPoint> corners;
  for (const DisplayPoint& pixel : pixels) corners.push_back(centerOfPixel(pixel.x(), pixel.y()));
  return ScreenPolygon(corners);
}

}  // namespace

std::vector<Index> verticesInScreenPolygon(vtkRenderer& renderer, SurfacePicker& picker,
                                           std::span<const DisplayPoint> polygon, ScreenReach reach)
{
  const DisplayTransform display(renderer);
  const VisibleSurface& surface = picker.surface();
  const ScreenPolygon outline = throughCenters(polygon);
  std::vector<Index> inside;
  for (Index v = 0; v < surface.positions().rows(); ++v) {
    const DisplayTransform::Shown shown = display.show(surface.positions().row(v));
    if (!(shown.depth > 0) || !display.isInside(shown.point) || !outline.contains(shown.point)) continue;
    if (surface.trianglesAt(v).empty()) continue;
    if (reach == ScreenReach::Through || surface.isVertexVisible(v, display)) inside.push_back(v);
  }
  return inside;
}

}  // namespace holdfast
