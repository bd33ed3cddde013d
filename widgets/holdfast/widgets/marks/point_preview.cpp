#include "holdfast/widgets/marks/point_preview.h"

#include <holdfast/widgets/marks/constraint_glyphs.h>

namespace holdfast {
namespace {

// A share of a ball's diameter.
constexpr double kPreviewBallSize = 0.8;
constexpr double kShapeSize = 1.4;
constexpr double kRingSize = 2.4;

}  // namespace

void PointPreview::set(const std::optional<PreviewedPoint>& point)
{
  const bool isOnEdge = point && point->kind == MarkKind::Edge;
  const bool isInFace = point && point->kind == MarkKind::Face;
  const auto show = [&](PointSprites& sprites, bool isShown) {
    sprites.set(isShown ? std::vector<Sprite>{{point->place, kAccentColor}} : std::vector<Sprite>{});
  };
  show(bead_, isOnEdge);
  show(triangle_, isInFace);
  show(ball_, point && !isOnEdge && !isInFace);
  show(ring_, point.has_value());
}

void PointPreview::setBallPixels(double pixels)
{
  ball_.setPixels(kPreviewBallSize * pixels);
  bead_.setPixels(kShapeSize * pixels);
  triangle_.setPixels(kShapeSize * pixels);
  ring_.setPixels(kRingSize * pixels);
}

}  // namespace holdfast
