#include "holdfast/widgets/picking/screen_polygon.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace holdfast {
namespace {

// Of a few pixels' height for what fits a screen.
constexpr std::size_t kBands = 256;

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

}  // namespace holdfast
