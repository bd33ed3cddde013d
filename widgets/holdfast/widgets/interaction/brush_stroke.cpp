#include "holdfast/widgets/interaction/brush_stroke.h"

#include <algorithm>
#include <cmath>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/interaction_events.h>

namespace holdfast {
namespace {

// Of the radius.
constexpr double kDabSpacing = 0.4;

}  // namespace

bool BrushStroke::dab(const DisplayPoint& pixel, double radiusPixels, const SurfacePicker& picker,
                      vtkRenderer& renderer)
{
  const auto pick = picker.pick(renderer, pixel.x(), pixel.y(), PickKind::Face, 0);
  if (!pick) return false;
  const Vector3 center = atDepthOf(renderer, pick->place, pixel);
  const Vector3 border = atDepthOf(renderer, pick->place, pixel + DisplayPoint(radiusPixels, 0));
  const VisibleSurface& surface = *picker.surface();
  auto touched = regions_->within((border - center).norm(), pick->place, pick->face, surface.positions());
  std::erase_if(touched, [&](Index v) { return !surface.isKept(surface.positions().row(v)); });
  reached_ = joined(reached_, touched, SelectionMode::Add);
  return true;
}

bool BrushStroke::paintTo(const DisplayPoint& pixel, double radiusPixels,
                          const std::shared_ptr<const VisibleSurface>& surface, vtkRenderer& renderer)
{
  const SurfacePicker picker(surface);
  const DisplayPoint from = at_.value_or(pixel);
  const double dabs = std::ceil((pixel - from).norm() / (kDabSpacing * radiusPixels));
  const int count = std::max(1, static_cast<int>(dabs));
  bool isOnSurface = false;
  for (int k = 1; k <= count; ++k) isOnSurface = dab(from + (pixel - from) * k / count, radiusPixels, picker, renderer);
  at_ = pixel;
  return isOnSurface;
}

}  // namespace holdfast
