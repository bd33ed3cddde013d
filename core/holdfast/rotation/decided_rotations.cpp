#include "holdfast/rotation/decided_rotations.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/QR>

#include <holdfast/geometry/rotation_fit.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

// Gaps are closed to this share of their limit, so that rounding elsewhere does not open them again.
constexpr double kClosed = 0.5;

// The sine of the angle between two directions that say no plane: that of points on a line, see `kRankOfFit`.
constexpr double kOnLine = 1e-6;

// Newton's method on several bodies: steps are shortened to this (radians), and quadratic convergence needs far fewer.
constexpr double kLongestStep = 0.5;
constexpr int kMostNewtonRounds = 60;

// What bodies in a line are bent by before they are turned together, radians.
constexpr double kBend = 0.05;

// Bodies that hang together and turn at once; their equations are dense.
constexpr std::size_t kMostTogether = 32;

/// The least turn about `axis` (of length 1) that takes `from` nearest to `to`; none where either lies on the axis.
Eigen::Quaterniond turnAbout(const Vector3& axis, const Vector3& from, const Vector3& to)
{
  const Vector3 a = from - axis.dot(from) * axis;
  const Vector3 b = to - axis.dot(to) * axis;
  if (a.norm() <= kOnLine * from.norm() || b.isZero(0)) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(std::atan2(axis.dot(a.cross(b)), a.dot(b)), axis));
}

/// How much longer one of two vectors is than the other.
double lengthDifference(const Vector3& a, const Vector3& b)
{
  return std::abs(a.norm() - b.norm());
}

Vector3 meanOf(const std::vector<Term>& rotation, const Columns3& q)
{
  Vector3 mean = Vector3::Zero();
  for (const Term& term : rotation) mean += term.coefficient * q.row(term.index).transpose();
  return mean;
}

}  // namespace

std::vector<Index> closedWhereFound(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                    const SolverMesh& mesh, const Diagnosis& diagnosis, Columns3 q)
{
  if (!diagnosis.hasConflicts() || system.rotated.empty()) return {};
  DecidedRotations decided(eliminated, system, mesh);
  decided.settle(system, q);
  std::vector<Index> rows = decided.closedRows();
  std::erase_if(rows, [&](Index row) { return diagnosis.status[row] != RowStatus::Conflicting; });
  return rows;
}

Vector3 DecidedRotations::gapAt(const TurningGap& gap) const
{
  Vector3 result = gap.asked;
  for (const auto& [body, arm] : gap.arms) result -= turns_[body].R * arm;
  return result;
}

bool DecidedRotations::isClosed(const TurningGap& gap) const
{
  return gapAt(gap).norm() <= kClosed * gap.limit;
}

bool DecidedRotations::areClosed(const std::vector<Index>& places) const
{
  return std::ranges::all_of(places, [&](Index place) { return isClosed(turning_.gaps[place]); });
}

bool DecidedRotations::isAlone(const TurningGap& gap) const
{
  return gap.arms.size() == 1 && !turns_[gap.arms.front().body].isCoupled;
}

void DecidedRotations::settle(const ConstraintSystem& system, Columns3& q)
{
  if (isEmpty()) return;
  open_.clear();
  for (std::size_t b = 0; b < turns_.size(); ++b) {
    const std::vector<Index>& rotated = turning_.bodies[b].rotated;
    turns_[b] = {};
    if (!rotated.empty()) turns_[b].R = rotationExp(meanOf(system.rotated[rotated.front()].rotation, q));
  }
  for (Index k = 0; k < static_cast<Index>(turning_.gaps.size()); ++k) close(k);
  for (const Index k : open_) narrow(k);
  for (const TurningBody* body : turnedBodies())
    for (const Index unknown : body->unknowns)
      q.row(unknown) = rotationLogNear(turns_[turning_.bodyOfUnknown[unknown]].R, Vector3(q.row(unknown)));
}

/// Closes the gap if that is possible beside all that were closed before; else turns nothing.
void DecidedRotations::close(Index place)
{
  const TurningGap& gap = turning_.gaps[place];
  const bool wasAlone = isAlone(gap);
  if (!isClosed(gap) && !(wasAlone ? closeAlone(gap) : closeTogether(gap))) return open_.push_back(place);
  for (const auto& [body, arm] : gap.arms) {
    turns_[body].closed.push_back(place);
    turns_[body].isCoupled = turns_[body].isCoupled || gap.arms.size() > 1;
  }
  narrow(place);
}

/// The rotation of the only body of the gap, turned by what it is free to as near to closing it as that leads.
Eigen::Quaterniond DecidedRotations::turnedTowards(const TurningGap& gap) const
{
  const auto& [body, arm] = gap.arms.front();
  const auto& [R, freedom, axis, closed, deciding, isCoupled, hasTurned] = turns_[body];
  if (freedom == TurningFreedom::None || gap.asked.norm() <= gap.limit) return R;
  const bool isFree = freedom == TurningFreedom::All;
  const Eigen::Quaterniond turn =
      isFree ? shortestRotation(R * arm, gap.asked).rotation : turnAbout(axis, R * arm, gap.asked);
  return (turn * R).normalized();
}

void DecidedRotations::setRotation(Index body, const Eigen::Quaterniond& R)
{
  turns_[body].R = R;
  turns_[body].hasTurned = true;
}

bool DecidedRotations::closeAlone(const TurningGap& gap)
{
  const Index body = gap.arms.front().body;
  const Turn before = turns_[body];
  setRotation(body, turnedTowards(gap));
  if (isClosed(gap)) return true;
  // What was closed by points near to one another says directions to few digits: all together say them best.
  Eigen::Matrix3d covariance = gap.asked * gap.arms.front().arm.transpose();
  for (const Index place : before.closed)
    covariance += turning_.gaps[place].asked * turning_.gaps[place].arms.front().arm.transpose();
  setRotation(body, fittedRotation(covariance, turns_[body].R));
  if (isClosed(gap) && areClosed(before.closed)) return true;
  turns_[body] = before;
  return false;
}

/// Takes from the only body of the gap the freedom that would open it, or lead away from it where it is open.
void DecidedRotations::narrow(Index place)
{
  const TurningGap& gap = turning_.gaps[place];
  if (!isAlone(gap)) return;
  const auto& [body, arm] = gap.arms.front();
  if (!isClosed(gap) && turns_[body].freedom != TurningFreedom::None) setRotation(body, turnedTowards(gap));
  Turn& turn = turns_[body];
  const Vector3 direction = (turn.R * arm).normalized();
  const bool isFirst = turn.freedom == TurningFreedom::All;
  if (turn.freedom == TurningFreedom::None) return;
  if (!isFirst && turn.axis.cross(direction).norm() <= kOnLine) return;
  turn.freedom = isFirst ? TurningFreedom::AboutAxis : TurningFreedom::None;
  if (isFirst) turn.axis = direction;
  turn.deciding.push_back(place);
}

/// Newton's method for the rotations of all bodies that hang together with those of the gap, by the shortest steps.
bool DecidedRotations::closeTogether(const TurningGap& gap)
{
  const BodyGroup group = groupOf(gap);
  if (group.bodies.size() > kMostTogether) return false;
  const std::vector<Turn> before = turns_;
  if (turnUntilClosed(group, gap)) return true;
  // Bodies in a line say not to which side they bend: they are bent, each about an axis of its own.
  turns_ = before;
  for (const Index body : group.bodies) {
    const auto k = static_cast<double>(body);
    const Vector3 axis(std::sin(k + 1), std::cos(2 * k), std::sin(3 * k + 2));
    setRotation(body, (rotationExp(kBend / 2 * axis.normalized()) * turns_[body].R).normalized());
  }
  if (turnUntilClosed(group, gap)) return true;
  turns_ = before;
  return false;
}

bool DecidedRotations::turnUntilClosed(const BodyGroup& group, const TurningGap& gap)
{
  const auto isDone = [&] { return isClosed(gap) && areClosed(group.closed); };
  for (int round = 0; round < kMostNewtonRounds && !isDone(); ++round)
    if (!turnTogether(group, gap)) break;
  return isDone();
}

DecidedRotations::BodyGroup DecidedRotations::groupOf(const TurningGap& gap) const
{
  std::set<Index> bodies;
  std::set<Index> closed;
  std::vector<Index> next;
  for (const auto& [body, arm] : gap.arms) next.push_back(body);
  while (!next.empty() && bodies.size() <= kMostTogether) {
    const Index body = next.back();
    next.pop_back();
    if (!bodies.insert(body).second) continue;
    for (const Index place : turns_[body].closed)
      if (closed.insert(place).second)
        for (const auto& [other, arm] : turning_.gaps[place].arms) next.push_back(other);
  }
  return {{bodies.begin(), bodies.end()}, {closed.begin(), closed.end()}};
}

bool DecidedRotations::turnTogether(const BodyGroup& group, const TurningGap& gap)
{
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3 * static_cast<Index>(group.closed.size() + 1),
                                            3 * static_cast<Index>(group.bodies.size()));
  Eigen::VectorXd left(J.rows());
  Index row = 0;
  const auto add = [&](const TurningGap& one) {
    left.segment<3>(row) = gapAt(one);
    for (const auto& [body, arm] : one.arms) {
      const Index column = 3 * (std::ranges::lower_bound(group.bodies, body) - group.bodies.begin());
      const Vector3 reached = turns_[body].R * arm;
      for (int k = 0; k < 3; ++k) J.block<3, 1>(row, column + k) = Vector3::Unit(k).cross(reached);
    }
    row += 3;
  };
  for (const Index place : group.closed) add(turning_.gaps[place]);
  add(gap);
  Eigen::VectorXd w = J.completeOrthogonalDecomposition().solve(left);
  if (!w.allFinite() || w.isZero(0)) return false;
  w *= std::min(1.0, kLongestStep / w.cwiseAbs().maxCoeff());
  for (std::size_t k = 0; k < group.bodies.size(); ++k) {
    const Vector3 turn = w.segment<3>(3 * static_cast<Index>(k));
    setRotation(group.bodies[k], (rotationExp(turn / 2) * turns_[group.bodies[k]].R).normalized());
  }
  return true;
}

ConstraintSystem DecidedRotations::withTurnedVectors(ConstraintSystem system) const
{
  for (std::size_t b = 0; b < turns_.size(); ++b) {
    if (!turns_[b].hasTurned || !turning_.bodies[b].unknowns.empty()) continue;
    const RotatedVector& vector = system.rotated[turning_.bodies[b].rotated.front()];
    ConstraintRow& row = system.rows[vector.row];
    row.target = turns_[b].R * vector.rest;
    row.shift = row.target - vector.rest;
  }
  return system;
}

std::vector<const TurningBody*> DecidedRotations::turnedBodies() const
{
  std::vector<const TurningBody*> result;
  for (std::size_t b = 0; b < turns_.size(); ++b)
    if (turns_[b].hasTurned) result.push_back(&turning_.bodies[b]);
  return result;
}

std::vector<Index> DecidedRotations::closedRows() const
{
  std::vector<Index> rows;
  for (std::size_t k = 0; k < turning_.gaps.size(); ++k)
    if (!std::ranges::binary_search(open_, static_cast<Index>(k))) rows.push_back(turning_.gaps[k].row);
  return rows;
}

std::map<Index, std::vector<Index>> DecidedRotations::reasons() const
{
  std::map<Index, std::vector<Index>> result;
  for (const Index place : open_) result[turning_.gaps[place].row] = contradicted(turning_.gaps[place]);
  return result;
}

std::vector<Index> DecidedRotations::contradicted(const TurningGap& gap) const
{
  std::map<Index, double> circuit;
  const auto add = [&](const TurningGap& other, double sign) {
    for (const Term& term : other.circuit) circuit[term.index] += sign * term.coefficient;
  };
  const auto rows = [&] {
    std::vector<Index> result;
    for (const auto& [row, coefficient] : circuit)
      if (row != gap.row && std::abs(coefficient) > kCoefficientThreshold) result.push_back(row);
    return result;
  };
  add(gap, 1);
  const auto& [body, arm] = gap.arms.front();
  const bool isLengthWrong = lengthDifference(gap.asked, arm) > gap.limit;
  if (gap.arms.size() > 1 || turns_[body].isCoupled || isLengthWrong) return rows();
  for (const Index place : turns_[body].closed) {
    const TurningGap& other = turning_.gaps[place];
    if (other.row > gap.row) break;
    const double limit = gap.limit + other.limit;
    if (lengthDifference(gap.asked - other.asked, arm - other.arms.front().arm) <= limit) continue;
    add(other, -1);
    return rows();
  }
  for (const Index place : turns_[body].deciding)
    if (turning_.gaps[place].row < gap.row) add(turning_.gaps[place], 1);
  return rows();
}

}  // namespace holdfast
