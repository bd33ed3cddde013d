#include "holdfast/operators/cotangents.h"

#include <cmath>

#include <Eigen/Geometry>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

Vector3 corner(const Positions& positions, const Triangle& triangle, int k)
{
  return positions.row(triangle[k % 3]);
}

using Parts = std::array<double, 3>;

/// The parts of the Voronoi cells of the corners that lie in the triangle: an eighth of each of the two sides at a
/// corner, squared, times the cotangent of the angle across.
Parts voronoiParts(const Positions& positions, const Triangle& triangle)
{
  const CornerCotangents cotangents = cornerCotangents(positions, triangle);
  Parts parts{};
  for (int k = 0; k < 3; ++k) {
    const Vector3 p = corner(positions, triangle, k);
    const double toNext = (corner(positions, triangle, k + 1) - p).squaredNorm();
    const double toPrevious = (corner(positions, triangle, k + 2) - p).squaredNorm();
    parts[k] = 0.125 * (toNext * cotangents[(k + 2) % 3] + toPrevious * cotangents[(k + 1) % 3]);
  }
  return parts;
}

Parts mixedParts(const Positions& positions, const Triangle& triangle)
{
  const Vector3 a = corner(positions, triangle, 0);
  const double whole = 0.5 * (corner(positions, triangle, 1) - a).cross(corner(positions, triangle, 2) - a).norm();
  if (whole == 0) return {0, 0, 0};
  const CornerCotangents cotangents = cornerCotangents(positions, triangle);
  const auto obtuse = std::find_if(cotangents.begin(), cotangents.end(), [](double c) { return c < 0; });
  if (obtuse == cotangents.end()) return voronoiParts(positions, triangle);
  Parts parts{whole / 4, whole / 4, whole / 4};
  parts[obtuse - cotangents.begin()] = whole / 2;
  return parts;
}

/// Returns for each unknown the sum of its parts.
Eigen::VectorXd summedParts(const Positions& positions, const std::vector<Triangle>& triangles,
                            Parts (*partsOf)(const Positions&, const Triangle&))
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(positions.rows());
  for (const Triangle& triangle : triangles) {
    const Parts parts = partsOf(positions, triangle);
    for (int k = 0; k < 3; ++k) areas[triangle[k]] += parts[k];
  }
  return areas;
}

}  // namespace

CornerCotangents cornerCotangents(const Positions& positions, const Triangle& triangle)
{
  CornerCotangents result{};
  for (int k = 0; k < 3; ++k) {
    const Vector3 p = corner(positions, triangle, k);
    const Vector3 u = corner(positions, triangle, k + 1) - p;
    const Vector3 v = corner(positions, triangle, k + 2) - p;
    result[k] = u.dot(v) / u.cross(v).norm();
  }
  return result;
}

std::vector<CornerCotangents> cornerCotangents(const Positions& positions, const std::vector<Triangle>& triangles)
{
  std::vector<CornerCotangents> result(triangles.size());
  parallelBlocks(static_cast<Index>(triangles.size()),
                 [&](Index t) { result[t] = cornerCotangents(positions, triangles[t]); });
  return result;
}

CornerCotangents guarded(const CornerCotangents& cotangents)
{
  CornerCotangents result{};
  const double cot60 = 1 / std::sqrt(3.0);
  for (int k = 0; k < 3; ++k)
    result[k] = std::isnan(cotangents[k]) ? cot60 : std::clamp(cotangents[k], -kCotangentCap, kCotangentCap);
  return result;
}

std::vector<Index> guardAll(std::vector<CornerCotangents>& cotangents, const std::vector<Triangle>& triangles)
{
  std::vector<Index> touched;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const CornerCotangents safe = guarded(cotangents[t]);
    if (safe != cotangents[t]) touched.insert(touched.end(), triangles[t].begin(), triangles[t].end());
    cotangents[t] = safe;
  }
  return sortedOnce(std::move(touched));
}

Eigen::VectorXd mixedVoronoiAreas(const Positions& positions, const std::vector<Triangle>& triangles)
{
  return summedParts(positions, triangles, mixedParts);
}

Eigen::VectorXd literalVoronoiAreas(const Positions& positions, const std::vector<Triangle>& triangles)
{
  return summedParts(positions, triangles, voronoiParts);
}

}  // namespace holdfast
