#include "holdfast/mesh/vertex_normals.h"

#include <numeric>

#include <Eigen/Geometry>

#include <holdfast/threads/parallel.h>

namespace holdfast {

Vector3 areaVector(const Positions& positions, std::span<const int> polygon)
{
  if (polygon.size() < 3) return Vector3::Zero();
  // Relative to the first corner: far from the origin the plain sum would cancel.
  const Vector3 origin = positions.row(polygon[0]);
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vector3 a = positions.row(polygon[i]).transpose() - origin;
    const Vector3 b = positions.row(polygon[i + 1]).transpose() - origin;
    sum += a.cross(b);
  }
  return sum / 2;
}

Vector3 unitOrZero(const Vector3& vector)
{
  // Scaled first: no square over- or underflows, and a normal along an axis comes out exact.
  const double scale = vector.cwiseAbs().maxCoeff();
  if (!vector.allFinite() || scale == 0) return Vector3::Zero();
  return (vector / scale).normalized();
}

AreaWeightedNormals::AreaWeightedNormals(const Polygons& faces, std::span<const int> normalOfCorner, Index count)
    : faces_(faces), start_(static_cast<std::size_t>(count) + 1), areas_(faces.size(), 3), normals_(count, 3)
{
  assert(static_cast<Index>(normalOfCorner.size()) == faces.cornerCount());
  for (const Index normal : normalOfCorner)
    if (normal >= 0) ++start_[normal + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  faceOf_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<int> next = start_;
  std::size_t corner = 0;
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < faces[f].size(); ++k, ++corner)
      if (const Index normal = normalOfCorner[corner]; normal >= 0) faceOf_[next[normal]++] = static_cast<int>(f);
}

const Positions& AreaWeightedNormals::at(const Positions& positions)
{
  parallelBlocks(areas_.rows(), [&](Index f) { areas_.row(f) = areaVector(positions, faces_[f]); });
  parallelBlocks(normals_.rows(), [&](Index n) {
    Vector3 sum = Vector3::Zero();
    for (int k = start_[n]; k < start_[n + 1]; ++k) sum += areas_.row(faceOf_[k]);
    normals_.row(n) = unitOrZero(sum);
  });
  return normals_;
}

Positions areaWeightedNormals(const Positions& positions, const Polygons& faces, std::span<const int> normalOfCorner,
                              Index count)
{
  return AreaWeightedNormals(faces, normalOfCorner, count).at(positions);
}

}  // namespace holdfast
