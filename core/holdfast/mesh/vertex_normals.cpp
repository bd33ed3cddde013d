#include "holdfast/mesh/vertex_normals.h"

#include <Eigen/Geometry>

namespace holdfast {

Vector3 areaVector(const Positions& positions, std::span<const Index> polygon)
{
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

Positions areaWeightedNormals(const Positions& positions, const Polygons& faces, std::span<const Index> normalOfCorner,
                              Index count)
{
  Positions normals(count, 3);
  areaWeightedNormals(positions, faces, normalOfCorner, normals);
  return normals;
}

void areaWeightedNormals(const Positions& positions, const Polygons& faces, std::span<const Index> normalOfCorner,
                         Positions& normals)
{
  assert(static_cast<Index>(normalOfCorner.size()) == faces.cornerCount());
  normals.setZero();
  std::size_t corner = 0;
  for (Index f = 0; f < faces.size(); ++f) {
    const Vector3 area = areaVector(positions, faces[f]);
    for (std::size_t k = 0; k < faces[f].size(); ++k, ++corner)
      if (normalOfCorner[corner] >= 0) normals.row(normalOfCorner[corner]) += area;
  }
  for (Index n = 0; n < normals.rows(); ++n) normals.row(n) = unitOrZero(normals.row(n));
}

std::vector<Index> cornerVertices(const Polygons& faces)
{
  std::vector<Index> vertices;
  vertices.reserve(faces.cornerCount());
  for (Index f = 0; f < faces.size(); ++f) vertices.insert(vertices.end(), faces[f].begin(), faces[f].end());
  return vertices;
}

}  // namespace holdfast
