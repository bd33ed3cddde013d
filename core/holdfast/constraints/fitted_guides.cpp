#include "holdfast/constraints/fitted_guides.h"

#include <Eigen/Eigenvalues>

#include <holdfast/constraints/handle_motion.h>

namespace holdfast {
namespace {

// Sums of squared distances that differ by less than this share tell no direction from another.
constexpr double kAlikeSpread = 1e-9;

// The sine of the angle from a coordinate axis below which a direction is along it.
constexpr double kAlongAxis = 1e-6;

/// Directions of a cloud of places, from the one along which it is thinnest.
struct Spread {
  Vector3 center;
  Vector3 squares;  ///< sums of squared distances, ascending
  Eigen::Matrix3d directions;
};

Spread spreadOf(const Positions& places)
{
  const Vector3 center = centroid(places);
  const Positions arms = places.rowwise() - center.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(arms.transpose() * arms);
  return {center, solver.eigenvalues(), solver.eigenvectors()};
}

/// Of two opposite directions that whose largest coordinate is positive.
Vector3 roundedToAxis(const Vector3& direction)
{
  Index along = 0;
  direction.cwiseAbs().maxCoeff(&along);
  Vector3 axis = Vector3::Unit(along);
  if (direction.cross(axis).norm() <= kAlongAxis) return axis;
  return direction[along] < 0 ? Vector3(-direction) : direction;
}

bool isApart(const Vector3& squares, Index a, Index b)
{
  return squares[b] - squares[a] > kAlikeSpread * squares[2];
}

/// The mean of places that have a coordinate in common has it too, to the last bit.
Vector3 between(const Vector3& center, const Positions& places)
{
  const Vector3 least = places.colwise().minCoeff();
  const Vector3 most = places.colwise().maxCoeff();
  return center.cwiseMax(least).cwiseMin(most);
}

}  // namespace

std::optional<OnPlane> fittedPlane(const Positions& places)
{
  const auto& [center, squares, directions] = spreadOf(places);
  if (!isApart(squares, 0, 1)) return std::nullopt;
  return OnPlane{between(center, places), roundedToAxis(directions.col(0)), 0};
}

std::optional<OnLine> fittedLine(const Positions& places)
{
  const auto& [center, squares, directions] = spreadOf(places);
  if (!isApart(squares, 1, 2)) return std::nullopt;
  return OnLine{between(center, places), roundedToAxis(directions.col(2))};
}

}  // namespace holdfast
