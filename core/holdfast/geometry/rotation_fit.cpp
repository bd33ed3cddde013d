#include "holdfast/geometry/rotation_fit.h"

#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

namespace holdfast {
namespace {

// Unit vectors whose sum is shorter than this are opposite within rounding.
constexpr double kOpposite = 8 * std::numeric_limits<double>::epsilon();

// Newton's method converges quadratically: a smaller step (radians) leaves less than a double holds.
constexpr double kLastNewtonStep = 1e-8;
// From nearer than this (radians) so many steps are enough; singular values serve elsewhere.
constexpr double kLargestNewtonStep = 1;
constexpr int kMostNewtonSteps = 8;

/// Points about their mean. The first is taken off before: a mean of large numbers would cost digits.
Positions centered(const Positions& points)
{
  Positions result = points.rowwise() - points.row(0);
  result.rowwise() -= Eigen::RowVector3d(result.colwise().mean());
  return result;
}

/// The points in units of their largest coordinate, so that no square leaves the range of doubles.
Positions inOwnUnits(const Positions& points)
{
  const double size = points.cwiseAbs().maxCoeff();
  return size > 0 ? Positions(points / size) : points;
}

/// The unit vector across `direction` and across the coordinate axis that is farthest from it.
Vector3 across(const Vector3& direction)
{
  int axis = 0;
  direction.cwiseAbs().minCoeff(&axis);
  return direction.cross(Vector3::Unit(axis)).normalized();
}

/// R of the covariance H = sum of p t^T, and whether it is the only best one.
RotationFit rotationOfCovariance(const Eigen::Matrix3d& H)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d& U = svd.matrixU();
  const Eigen::Matrix3d& V = svd.matrixV();
  const Vector3& s = svd.singularValues();
  if (s[0] == 0) return {};
  if (s[1] <= kRankOfFit * s[0]) return {shortestRotation(U.col(0), V.col(0)).rotation.toRotationMatrix(), false};
  const double handedness = (V * U.transpose()).determinant() > 0 ? 1 : -1;
  const Eigen::Matrix3d R = V * Vector3(1, 1, handedness).asDiagonal() * U.transpose();
  return {R, s[1] + handedness * s[2] > kRankOfFit * s[0]};
}

}  // namespace

RotationFit fitRotation(const Positions& points, const Positions& targets)
{
  assert(points.rows() > 0 && points.rows() == targets.rows());
  return rotationOfCovariance(inOwnUnits(centered(points)).transpose() * inOwnUnits(centered(targets)));
}

Eigen::Quaterniond fittedRotation(const Eigen::Matrix3d& H, const Eigen::Quaterniond& near)
{
  // With R exp(w) in place of R, trace(R^T H) grows by g . w - w . K w / 2. A positive definite K where g = 0 is that
  // of the only maximum: its eigenvalues are sums of two singular values, the least with the sign of the determinant.
  Eigen::Quaterniond R = near;
  for (int step = 0; step < kMostNewtonSteps; ++step) {
    const Eigen::Matrix3d M = R.toRotationMatrix().transpose() * H;
    const Vector3 g(M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1));
    const Eigen::Matrix3d K = M.trace() * Eigen::Matrix3d::Identity() - (M + M.transpose()) / 2;
    Eigen::Matrix3d adjugate;
    for (int k = 0; k < 3; ++k) adjugate.col(k) = K.col((k + 1) % 3).cross(K.col((k + 2) % 3));
    const double determinant = K.col(0).dot(adjugate.col(0));
    const bool isDefinite = K.trace() > 0 && adjugate.trace() > 0;
    if (!(isDefinite && determinant > kRankOfFit * adjugate.trace() * K.trace())) break;
    if (g.isZero(0)) return R;
    const Vector3 w = adjugate * g / determinant;
    if (!(w.norm() <= kLargestNewtonStep)) break;
    R = (R * Eigen::Quaterniond(1, w.x() / 2, w.y() / 2, w.z() / 2)).normalized();
    if (w.norm() <= kLastNewtonStep) return R;
  }
  const double size = H.cwiseAbs().maxCoeff();
  if (!(size > 0)) return near;
  const Eigen::Matrix3d fromNear = near.toRotationMatrix().transpose() * (H / size);
  return (near * Eigen::Quaterniond(rotationOfCovariance(fromNear.transpose()).R)).normalized();
}

Eigen::Quaterniond fittedRotationAbout(const Vector3& axis, const Eigen::Matrix3d& H, const Eigen::Quaterniond& near)
{
  // With T a turn by theta, trace((T R)^T H) = cos theta (trace M - a . M a) + sin theta (a . w) + a . M a.
  const Eigen::Matrix3d M = H * near.toRotationMatrix().transpose();
  const Vector3 w(M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1));
  const double angle = std::atan2(axis.dot(w), M.trace() - axis.dot(M * axis));
  return angle == 0 ? near : (Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * near).normalized();
}

DirectionTurn shortestRotation(const Vector3& from, const Vector3& to)
{
  const Vector3 a = from.stableNormalized();
  const Vector3 b = to.stableNormalized();
  Vector3 middle = a + b;
  if (middle.norm() <= kOpposite) {
    const Vector3 axis = across(a);
    return {Eigen::Quaterniond(0, axis.x(), axis.y(), axis.z()), false};
  }
  const Vector3 difference = b - a;
  const bool isObtuse = a.dot(b) < 0;
  // The middle of directions that are nearly opposite is as short as its rounding is large: it has to stay across b -
  // a.
  if (isObtuse) middle -= difference * (difference.dot(middle) / difference.squaredNorm());
  // The same up to rounding, which is small beside the shorter of the two.
  const Vector3 v = a.cross(isObtuse ? middle : difference);
  return {Eigen::Quaterniond(a.dot(middle), v.x(), v.y(), v.z()).normalized(), true};
}

}  // namespace holdfast
