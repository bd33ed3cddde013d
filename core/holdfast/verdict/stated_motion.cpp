#include "holdfast/verdict/stated_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Geometry>

#include <holdfast/geometry/rotation_fit.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/surface/place_tree.h>

namespace holdfast {
namespace {

// Fewer do not say how they turn.
constexpr std::size_t kLeastPoints = 3;

// A surface around a region reaches as far from its edge as that from its middle.
constexpr double kReachAround = 2;

Vector3 placeAtRest(const ConstraintRow& row)
{
  return row.target - row.shift;
}

bool isPointRow(const ConstraintRow& row)
{
  return row.kind == RowKind::Position && row.corners > 0 && row.directions.areAll();
}

using RowList = std::vector<Index>;

double rootMeanSquare(const Positions& vectors)
{
  const Eigen::Map<const Eigen::VectorXd> numbers(vectors.data(), vectors.size());
  return numbers.stableNorm() / std::sqrt(static_cast<double>(vectors.rows()));
}

/// Without their mean, which `mean` becomes.
Positions aboutMean(const Positions& places, Vector3& mean)
{
  const Positions fromFirst = places.rowwise() - places.row(0);
  mean = (fromFirst.colwise().mean() + places.row(0)).transpose();
  return fromFirst.rowwise() - Eigen::RowVector3d(fromFirst.colwise().mean());
}

std::optional<WholeMotion> motionOf(const ConstraintSystem& system, const RowList& rows, int part)
{
  Positions points(static_cast<Index>(rows.size()), 3);
  Positions targets(points.rows(), 3);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    points.row(static_cast<Index>(k)) = placeAtRest(system.rows[rows[k]]);
    targets.row(static_cast<Index>(k)) = system.rows[rows[k]].target;
  }
  const RotationFit fit = fitRotation(points, targets);
  if (!fit.isDetermined) return std::nullopt;
  WholeMotion whole;
  whole.part = part;
  TargetMotion& motion = whole.motion;
  const Vector3 q = rotationLog(fit.R);
  motion.degrees = holdfast::angleDegrees(q);
  motion.axis = q.stableNormalized();
  Vector3 from;
  Vector3 to;
  points = aboutMean(points, from);
  targets = aboutMean(targets, to);
  const Positions rotatedPoints = points * fit.R.transpose();
  motion.scale = rotatedPoints.cwiseProduct(targets).sum() / rotatedPoints.squaredNorm();
  motion.shift = to - from;
  motion.moved = rootMeanSquare(targets - points);
  motion.left = rootMeanSquare(targets - motion.scale * rotatedPoints);
  for (const Index row : rows) whole.constraints.push_back(system.rows[row].constraint);
  whole.constraints = sortedOnce(std::move(whole.constraints));
  return whole;
}

bool isSwap(const ConstraintRow& a, const ConstraintRow& b)
{
  const double asStated = a.shift.norm() + b.shift.norm();
  const double swapped = (a.target - placeAtRest(b)).norm() + (b.target - placeAtRest(a)).norm();
  return swapped < kLargestShareLeft * asStated;
}

/// The points that are to move by a distance that is seen.
RowList movedPoints(const ConstraintSystem& system, const SolverMesh& mesh)
{
  RowList rows;
  for (std::size_t r = 0; r < system.rows.size(); ++r)
    if (isPointRow(system.rows[r]) && system.rows[r].shift.norm() > kVisible * mesh.diagonal)
      rows.push_back(static_cast<Index>(r));
  return rows;
}

/// The places in the list of the rows that are swapped with another, each once.
std::vector<Index> swappedPoints(const ConstraintSystem& system, const RowList& moved)
{
  Positions places(static_cast<Index>(moved.size()), 3);
  for (Index k = 0; k < places.rows(); ++k) places.row(k) = placeAtRest(system.rows[moved[k]]);
  const PlaceTree tree(places);
  std::vector<Index> swapped;
  for (Index k = 0; k < places.rows(); ++k) {
    const ConstraintRow& row = system.rows[moved[k]];
    const Index other = tree.nearest(row.target, std::numeric_limits<double>::max(), k);
    if (other >= 0 && isSwap(row, system.rows[moved[other]])) swapped.push_back(row.constraint);
  }
  return sortedOnce(std::move(swapped));
}

/// The vectors that are to be about the opposite of what they are at rest.
void addReversed(std::vector<Index>& constraints, const ConstraintSystem& system)
{
  std::vector<bool> isKept(system.rows.size(), false);
  for (const RotatedVector& vector : system.rotated) isKept[vector.row] = true;
  for (std::size_t r = 0; r < system.rows.size(); ++r) {
    const ConstraintRow& row = system.rows[r];
    if (row.kind != RowKind::Relative || isKept[r]) continue;
    const Vector3 rest = placeAtRest(row);
    if ((row.target + rest).norm() < kLargestShareLeft * row.shift.norm()) constraints.push_back(row.constraint);
  }
}

/// The unknowns of each constraint that could turn and states no rotation: rigid regions, and handles without a
/// rotation. What slides says nothing of rotations.
std::map<Index, std::vector<Index>> regionsWithoutRotation(const ConstraintSystem& system)
{
  std::map<Index, std::vector<Index>> regions;
  for (const ConstraintRow& row : system.rows) {
    if (!row.directions.areAll()) continue;
    if (row.kind == RowKind::Region)
      for (const Term& term : row.terms) regions[row.constraint].push_back(term.index);
    if (row.kind == RowKind::Position && row.corners == 0 && !row.shift.isZero(0))
      regions[row.constraint].push_back(row.terms.front().index);
  }
  std::vector<Index> stated;
  for (const GivenRotation& given : system.rotations)
    if (given.isStated) stated.push_back(given.unknown);
  stated = sortedOnce(std::move(stated));
  for (auto& [constraint, unknowns] : regions) unknowns = sortedOnce(std::move(unknowns));
  std::erase_if(regions, [&](const auto& region) {
    return std::ranges::any_of(region.second,
                               [&](Index unknown) { return std::ranges::binary_search(stated, unknown); });
  });
  return regions;
}

RotationFit rotationOfUnknowns(const DeformedSurface& surface, const std::vector<Index>& unknowns)
{
  Positions before(static_cast<Index>(unknowns.size()), 3);
  Positions after(before.rows(), 3);
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const Index vertex = surface.mesh.weld.firstVertexOf[unknowns[k]];
    before.row(static_cast<Index>(k)) = surface.atRest.row(vertex);
    after.row(static_cast<Index>(k)) = surface.now.row(vertex);
  }
  return before.rows() == 0 ? RotationFit() : fitRotation(before, after);
}

/// The unknowns of the same part that lie around a region, as far again as it reaches itself.
std::vector<Index> surroundingsOf(const DeformedSurface& surface, const std::vector<Index>& region)
{
  const SolverMesh& mesh = surface.mesh;
  const Positions places = mesh.rest(region, Eigen::all);
  const Eigen::RowVector3d middle = places.colwise().mean();
  const double reach = kReachAround * (places.rowwise() - middle).rowwise().norm().maxCoeff();
  std::vector<Index> unknowns;
  for (Index u = 0; u < mesh.unknownCount(); ++u)
    if (mesh.componentOf[u] == mesh.componentOf[region.front()] && (mesh.rest.row(u) - middle).norm() <= reach &&
        !std::ranges::binary_search(region, u))
      unknowns.push_back(u);
  return unknowns;
}

}  // namespace

bool WholeMotion::explainsTargets() const
{
  return motion.left <= kLargestShareLeft * motion.moved;
}

std::vector<WholeMotion> wholeMotions(const ConstraintSystem& system, const SolverMesh& mesh)
{
  std::map<int, RowList> rowsOfParts;
  for (std::size_t r = 0; r < system.rows.size(); ++r)
    if (isPointRow(system.rows[r]))
      rowsOfParts[mesh.componentOf[system.rows[r].terms.front().index]].push_back(static_cast<Index>(r));
  std::vector<WholeMotion> motions;
  for (const auto& [part, rows] : rowsOfParts) {
    if (part < 0 || rows.size() < kLeastPoints) continue;
    if (std::optional<WholeMotion> motion = motionOf(system, rows, part)) motions.push_back(std::move(*motion));
  }
  return motions;
}

std::vector<Index> swappedTargets(const ConstraintSystem& system, const SolverMesh& mesh)
{
  const RowList moved = movedPoints(system, mesh);
  std::vector<Index> swapped = moved.empty() ? std::vector<Index>() : swappedPoints(system, moved);
  // Half a turn swaps every point with the one across.
  if (swapped.size() > 2 && 2 * swapped.size() > moved.size()) swapped.clear();
  addReversed(swapped, system);
  return sortedOnce(std::move(swapped));
}

namespace {

double degreesOf(const Eigen::Matrix3d& R)
{
  return holdfast::angleDegrees(rotationLog(R));
}

/// Tells whether detail of any size looks another way.
bool isVisibleTurn(double degrees)
{
  return 2 * std::sin(degrees / 2 * kDegree) > kVisibleDetail;
}

}  // namespace

std::vector<LevelRegion> levelRegions(const DeformedSurface& surface, const ConstraintSystem& system)
{
  std::vector<LevelRegion> level;
  for (const auto& [constraint, unknowns] : regionsWithoutRotation(system)) {
    const RotationFit own = rotationOfUnknowns(surface, unknowns);
    const RotationFit around = rotationOfUnknowns(surface, surroundingsOf(surface, unknowns));
    if (!own.isDetermined || !around.isDetermined) continue;
    const double degrees = degreesOf(own.R.transpose() * around.R);
    if (!isVisibleTurn(degreesOf(own.R)) && isVisibleTurn(degrees)) level.push_back({constraint, degrees});
  }
  return level;
}

}  // namespace holdfast
