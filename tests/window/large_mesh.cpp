#include "large_mesh.h"

#include <cmath>

#include "support/meshes.h"

namespace holdfast::test {

Mesh bumpyEllipsoid(Index divisions)
{
  Mesh mesh = box({2, 2, 2}, divisions);
  const Vector3 middle = mesh.positions.colwise().mean().transpose();
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vector3 out = (mesh.positions.row(v).transpose() - middle).normalized();
    const double bumps = 1 + 0.03 * std::sin(9 * out.x()) * std::sin(8 * out.y()) * std::sin(11 * out.z());
    mesh.positions.row(v) = bumps * out.cwiseProduct(Vector3(60, 50, 90)).transpose();
  }
  return mesh;
}

}  // namespace holdfast::test
