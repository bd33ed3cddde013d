#include "holdfast/widgets/picking/shown_edge.h"

#include <algorithm>
#include <cmath>

namespace holdfast {
namespace {

// An edge that passes the eye is looked at from this share of its farther end's depth onwards.
constexpr double kLeastDepth = 1e-6;

/// The share of the segment that is at least as deep as that.
struct Range {
  double low = 0;
  double high = 1;
};

Range inFrontOfEye(double depthA, double depthB)
{
  const double least = kLeastDepth * std::max(depthA, depthB);
  const double share = (least - depthA) / (depthB - depthA);
  if (depthA < least) return {share, 1};
  if (depthB < least) return {0, share};
  return {};
}

}  // namespace

std::optional<PointOfEdge> nearestOfEdge(const Vector3& a, const Vector3& b, const DisplayPoint& point,
                                         const DisplayTransform& display)
{
  const double depthA = display.show(a).depth;
  const double depthB = display.show(b).depth;
  if (!(std::max(depthA, depthB) > 0)) return std::nullopt;
  const Range range = inFrontOfEye(depthA, depthB);
  const auto placeAt = [&](double share) -> Vector3 { return (1 - share) * a + share * b; };
  const DisplayTransform::Shown low = display.show(placeAt(range.low));
  const DisplayTransform::Shown high = display.show(placeAt(range.high));
  const DisplayPoint along = high.point - low.point;
  const double squared = along.squaredNorm();
  const double s = squared > 0 ? std::clamp((point - low.point).dot(along) / squared, 0.0, 1.0) : 0.0;
  // Equal steps on the screen are longer ones along the edge where it is farther away.
  const double inRange = s * low.size / ((1 - s) * high.size + s * low.size);
  const double share = std::clamp(range.low + inRange * (range.high - range.low), 0.0, 1.0);
  return PointOfEdge{share, placeAt(share), (low.point + s * along - point).norm()};
}

}  // namespace holdfast
