#include "holdfast/widgets/marks/point_preview.h"

#include <vtkActor.h>

#include <holdfast/widgets/marks/constraint_glyphs.h>

namespace holdfast {
namespace {

// A share of a ball's diameter.
constexpr double kPreviewBallSize = 0.8;
constexpr double kShapeSize = 1.4;
constexpr double kRingSize = 2.4;

std::vector<Sprite> spritesIf(bool isShown, const std::optional<PreviewedPoint>& point)
{
  if (!isShown || !point) return {};
  return {{point->place, kAccentColor}};
}

}  // namespace

PointPreview::PointPreview()
{
  set({});
}

void PointPreview::set(const std::optional<PreviewedPoint>& point)
{
  const bool isOnEdge = point && point->kind == MarkKind::Edge;
  const bool isInFace = point && point->kind == MarkKind::Face;
  bead_.set(spritesIf(isOnEdge, point));
  triangle_.set(spritesIf(isInFace, point));
  ball_.set(spritesIf(!isOnEdge && !isInFace, point));
  ring_.set(spritesIf(true, point));
}

void PointPreview::setBallPixels(double pixels)
{
  ball_.setPixels(kPreviewBallSize * pixels);
  bead_.setPixels(kShapeSize * pixels);
  triangle_.setPixels(kShapeSize * pixels);
  ring_.setPixels(kRingSize * pixels);
}

}  // namespace holdfast
