#include "plate.h"

#include <algorithm>

#include "region.h"

namespace holdfast::generate {
namespace {

constexpr double kSide = 100;

// Fine on the left, coarse on the right, along a slanted line.
double edgeLengthAt(const Vector2& place)
{
  constexpr double kFine = 1.6, kCoarse = 7;
  const double across = std::clamp((place.x() + 0.25 * place.y() - 45) / 35, 0.0, 1.0);
  return kFine + (kCoarse - kFine) * across * across * (3 - 2 * across);
}

// Points from `from` to before `to`, spaced as `edgeLengthAt` wants.
Loop side(const Vector2& from, const Vector2& to)
{
  constexpr int kPieces = 10000;
  const auto at = [&](double t) -> Vector2 { return from + t * (to - from); };
  const double piece = (to - from).norm() / kPieces;
  double total = 0;
  for (int i = 0; i < kPieces; ++i) total += piece / edgeLengthAt(at((i + 0.5) / kPieces));
  const double scale = std::round(total) / total;
  Loop result{from};
  double steps = 0;
  for (int i = 0; i < kPieces; ++i) {
    steps += scale * piece / edgeLengthAt(at((i + 0.5) / kPieces));
    const bool isLast = static_cast<double>(result.size()) > std::round(total) - 0.5;
    if (steps >= static_cast<double>(result.size()) && !isLast) result.push_back(at((i + 1.0) / kPieces));
  }
  return result;
}

}  // namespace

GroupedMesh makePlate()
{
  const std::array<Vector2, 4> corners{Vector2(0, 0), Vector2(kSide, 0), Vector2(kSide, kSide), Vector2(0, kSide)};
  Loop outline;
  for (std::size_t i = 0; i < 4; ++i) {
    const Loop part = side(corners[i], corners[(i + 1) % 4]);
    outline.insert(outline.end(), part.begin(), part.end());
  }
  const Region region = meshRegion({outline}, edgeLengthAt);
  GroupedMesh result;
  for (const Vector2& point : region.points) result.points.emplace_back(point.x(), point.y(), 0);
  result.triangles = region.triangles;
  return result;
}

}  // namespace holdfast::generate
