#include "holdfast/document/own_axes.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <holdfast/geometry/centroid.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

// Variances that differ by less than this share of the largest have no axis that a user would expect.
constexpr double kAlike = 0.05;

/// Whether the face has every vertex that the point hangs on, or one in the same place.
bool holds(const std::vector<Index>& unknownOf, std::span<const Index> face, const SurfacePoint& point)
{
  return std::all_of(point.terms.begin(), point.terms.end(), [&](const Term& term) {
    return std::ranges::any_of(face, [&](Index corner) { return unknownOf[corner] == unknownOf[term.index]; });
  });
}

}  // namespace

Eigen::Matrix3d axesAbout(const Vector3& direction)
{
  const Vector3 z = unitOrZero(direction);
  if (z.isZero(0)) return Eigen::Matrix3d::Identity();
  Index across = 0;
  z.cwiseAbs().minCoeff(&across);
  const Vector3 x = (Vector3::Unit(across) - z[across] * z).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return axes;
}

Eigen::Matrix3d surfaceAxes(const Model& model, const SurfacePoint& point, const Positions& positions)
{
  Vector3 sum = Vector3::Zero();
  for (Index f = 0; f < model.mesh.faces.size(); ++f)
    if (holds(model.solverMesh.weld.unknownOf, model.mesh.faces[f], point))
      sum += areaVector(positions, model.mesh.faces[f]);
  return axesAbout(sum);
}

Eigen::Matrix3d principalAxes(const Positions& places)
{
  const Positions arms = places.rowwise() - centroid(places).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(arms.transpose() * arms);
  const Vector3 variances = solver.eigenvalues();
  const double flat = variances[1] - variances[0];
  const double slender = variances[2] - variances[1];
  if (!(std::max(flat, slender) > kAlike * variances[2])) return Eigen::Matrix3d::Identity();
  const Vector3 axis = solver.eigenvectors().col(flat > slender ? 0 : 2);
  Index along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  return axesAbout(axis[along] < 0 ? Vector3(-axis) : axis);
}

}  // namespace holdfast
