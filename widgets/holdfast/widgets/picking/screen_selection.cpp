#include "holdfast/widgets/picking/screen_selection.h"

namespace holdfast {
namespace {

// A few pixels high for polygons that fit a screen.
constexpr std::size_t kBands = 256;

ScreenPolygon throughCenters(std::span<const DisplayPoint> pixels)
{
  std::vector<DisplayPoint> corners;
  for (const DisplayPoint& pixel : pixels) corners.push_back(centerOfPixel(pixel.x(), pixel.y()));
  return ScreenPolygon(corners);
}

}  // namespace

ScreenPolygon::ScreenPolygon(std::span<const DisplayPoint> corners)
    : corners_(corners.begin(), corners.end()),
      bottom_(std::numeric_limits<double>::infinity()),
      top_(-std::numeric_limits<double>::infinity()),
      bands_(kBands)
{
  for (const DisplayPoint& corner : corners) {
    bottom_ = std::min(bottom_, corner.y());
    top_ = std::max(top_, corner.y());
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [low, high] = std::minmax(corners_[k].y(), endOf(k).y());
    for (std::size_t band = bandOf(low); band <= bandOf(high); ++band) bands_[band].push_back(k);
  }
}

bool ScreenPolygon::contains(const DisplayPoint& point) const
{
  if (!(point.y() >= bottom_ && point.y() <= top_)) return false;
  bool isInside = false;
  for (const std::size_t side : bands_[bandOf(point.y())]) {
    const DisplayPoint& from = corners_[side];
    const DisplayPoint& to = endOf(side);
    // A corner belongs to the side above it alone: a line through it crosses once or not at all.
    if ((from.y() <= point.y()) == (to.y() <= point.y())) continue;
    const double x = from.x() + (point.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
    if (point.x() < x) isInside = !isInside;
  }
  return isInside;
}

std::size_t ScreenPolygon::bandOf(double y) const
{
  const double height = top_ - bottom_;
  if (!(height > 0)) return 0;
  const auto band = static_cast<std::size_t>((y - bottom_) / height * static_cast<double>(kBands));
  return std::min(band, kBands - 1);
}

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
  if (!surface_->isShown(vertex) || !surface_->isKept(place)) return false;
  return reach_ == ScreenReach::Through || surface_->isVertexVisible(vertex, display_);
}

void ScreenSelection::advance(Index count)
{
  const Index end = std::min(next_ + count, surface_->positions().rows());
  for (; next_ < end; ++next_)
    if (isInside(next_)) inside_.push_back(next_);
}

}  // namespace holdfast
