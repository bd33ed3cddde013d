#include "holdfast/widgets/rotation_sphere/rotation_projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <Eigen/Eigenvalues>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

// A label names so many constraints and counts the others.
constexpr std::size_t kNamesInLabel = 3;

// Among directions that say equally little, those of coordinate axes, z before y before x, are not shown.
constexpr double kPreference = 1e-9;

// The frame stays as long as it hides no more than this share beyond what the best one hides.
constexpr double kHiddenShare = 0.02;

// The sine of the angle between two axes: about rounding.
constexpr double kSameAxis = 1e-9;

constexpr double kArcStep = 2 * std::numbers::pi / 180;

double liftOf(double halfAngle)
{
  return 1 + kTurnRise * std::max(0.0, halfAngle / std::numbers::pi - 1);
}

/// The shadow of a unit quaternion.
Vector3 shadow(const SphereFrame& frame, const Eigen::Quaterniond& rotation)
{
  return {rotation.vec().dot(frame.axes.col(0)), rotation.vec().dot(frame.axes.col(1)), rotation.w()};
}

std::string labelOf(const std::vector<std::string>& names)
{
  std::string label;
  for (std::size_t k = 0; k < std::min(names.size(), kNamesInLabel); ++k) label += (k == 0 ? "" : ", ") + names[k];
  if (names.size() > kNamesInLabel) label += " +" + std::to_string(names.size() - kNamesInLabel);
  return label;
}

bool isAlongOneAxis(const Vector3& a, const Vector3& b)
{
  return a.cross(b).norm() <= kSameAxis * a.norm() * b.norm();
}

int arcSteps(double halfAngle)
{
  return std::max(1, static_cast<int>(std::ceil(halfAngle / kArcStep)));
}

/// The right-handed frame that does not show `hidden`; x of the picture is the coordinate axis that it shows best.
SphereFrame frameWithout(const Vector3& hidden)
{
  Index shown = 0;
  hidden.cwiseAbs().minCoeff(&shown);
  SphereFrame frame;
  const Vector3 x = (Vector3::Unit(shown) - hidden[shown] * hidden).normalized();
  frame.axes << x, hidden.cross(x), hidden;
  return frame;
}

}  // namespace

std::vector<BoundaryRotation> boundaryRotations(const DeformResult& deformation)
{
  std::vector<BoundaryRotation> boundary;
  std::vector<std::vector<std::string>> names;
  std::map<std::array<double, 3>, std::size_t> placeOf;
  std::set<Index> named;
  for (const GivenRotation& given : deformation.details->system.rotations) {
    const auto [found, isNew] = placeOf.try_emplace({given.q.x(), given.q.y(), given.q.z()}, boundary.size());
    if (isNew) {
      boundary.push_back({given.q, ""});
      names.emplace_back();
    }
    if (named.insert(given.constraint).second)
      names[found->second].push_back(deformation.report.constraints[given.constraint].name);
  }
  for (std::size_t k = 0; k < boundary.size(); ++k) boundary[k].label = labelOf(names[k]);
  return boundary;
}

bool hasRotation(const std::vector<BoundaryRotation>& boundary)
{
  return std::any_of(boundary.begin(), boundary.end(),
                     [](const BoundaryRotation& value) { return !value.q.isZero(0); });
}

SphereFrame sphereFrame(const std::vector<BoundaryRotation>& boundary, const SphereFrame& before)
{
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const BoundaryRotation& value : boundary) spread += value.q * value.q.transpose();
  const double whole = spread.trace();
  if (whole == 0) return before;
  spread += kPreference * whole * Vector3(3, 2, 1).asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> ascending(spread);
  const Vector3 hiddenBefore = before.axes.col(2);
  if (hiddenBefore.dot(spread * hiddenBefore) <= ascending.eigenvalues()[0] + kHiddenShare * whole) return before;
  Vector3 hidden = ascending.eigenvectors().col(0);
  Index largest = 0;
  hidden.cwiseAbs().maxCoeff(&largest);
  // Seen from where the hidden axis points to the eye, as coordinate planes are drawn.
  if (hidden[largest] < 0) hidden = -hidden;
  return frameWithout(hidden);
}

Vector3 spherePlace(const SphereFrame& frame, const Vector3& q)
{
  return liftOf(q.norm()) * shadow(frame, rotationExp(q));
}

std::vector<Vector3> sphereArc(const SphereFrame& frame, const Vector3& from, const Vector3& to)
{
  std::vector<Vector3> places;
  if (isAlongOneAxis(from, to) || std::max(from.norm(), to.norm()) > std::numbers::pi) {
    const int steps = arcSteps((to - from).norm());
    for (int k = 0; k <= steps; ++k) places.push_back(spherePlace(frame, from + k / double(steps) * (to - from)));
    return places;
  }
  const Eigen::Vector4d a = rotationExp(from).coeffs();
  const Eigen::Vector4d b = rotationExp(to).coeffs();
  const double angle = 2 * std::atan2((b - a).norm(), (b + a).norm());
  const int steps = arcSteps(angle);
  for (int k = 0; k <= steps; ++k) {
    const double t = k / double(steps);
    const Eigen::Vector4d blend = std::sin((1 - t) * angle) * a + std::sin(t * angle) * b;
    places.push_back(shadow(frame, Eigen::Quaterniond(Eigen::Vector4d(blend.normalized()))));
  }
  return places;
}

}  // namespace holdfast
