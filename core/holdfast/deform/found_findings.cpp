#include "holdfast/deform/found_findings.h"

#include <deque>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/mesh/index_lists.h>

namespace holdfast {
namespace {

using std::numbers::pi;

// Logs are half angles. Two rotations that are a quarter turn at most from a third are within half a turn.
constexpr double kQuarterTurn = pi / 4;

// Two logs of one rotation are a whole turn apart, or more.
constexpr double kHalfOfATurn = pi / 2;

// Rotations that differ by more (as half angles, radians) are two: computed ones differ by rounding.
constexpr double kTwoRotations = 1e-9;

// A push is of this size: its square is lost beside it, and rounding is small beside it.
constexpr double kPush = 1e-6;

// What grows by less in an iteration has been pushed together by so little that it cannot be seen.
constexpr double kGrowth = 1e-4;

/// Tells whether rotations are given in some part that are too far apart for one log each.
bool haveTurns(const ConstraintSystem& system, const SolverMesh& mesh)
{
  std::vector<Index> firstOf(static_cast<std::size_t>(mesh.componentCount), -1);
  for (std::size_t k = 0; k < system.rotations.size(); ++k) {
    const Index part = mesh.componentOf[system.rotations[k].unknown];
    if (part < 0) continue;
    if (firstOf[part] < 0) firstOf[part] = static_cast<Index>(k);
    if ((system.rotations[k].q - system.rotations[firstOf[part]].q).norm() > kQuarterTurn) return true;
  }
  return false;
}

/// By unknown: the place of its given rotation in the system; -1 where none is given.
std::vector<Index> givenPlaces(const ConstraintSystem& system, Index unknownCount)
{
  std::vector<Index> places(static_cast<std::size_t>(unknownCount), -1);
  for (std::size_t k = 0; k < system.rotations.size(); ++k) places[system.rotations[k].unknown] = static_cast<Index>(k);
  return places;
}

/// Goes along edges from unknown to unknown, breadth first, and carries logs on from each to the next.
class CarriedLogs {
 public:
  CarriedLogs(const ConstraintSystem& system, const SolverMesh& mesh, const Columns3& q)
      : system_(system),
        mesh_(mesh),
        q_(q),
        triangles_(trianglesOfVertices(mesh.triangles, mesh.unknownCount())),
        given_(givenPlaces(system, mesh.unknownCount())),
        isReached_(given_.size(), false),
        carried_(q)
  {
  }

  /// The constraints that are reached with other turns than they state.
  [[nodiscard]] std::vector<Index> lost()
  {
    std::vector<bool> isBegun(static_cast<std::size_t>(mesh_.componentCount), false);
    for (const GivenRotation& given : system_.rotations) {
      const Index part = mesh_.componentOf[given.unknown];
      if (part < 0 || isBegun[part]) continue;
      isBegun[part] = true;
      isReached_[given.unknown] = true;
      carryOn(given.unknown);
    }
    return sortedOnce(std::move(lost_));
  }

 private:
  void carryOn(Index first)
  {
    std::deque<Index> next{first};
    for (; !next.empty(); next.pop_front())
      for (const Index t : triangles_[next.front()])
        for (const Index other : mesh_.triangles[t])
          if (!isReached_[other] && isPassable(next.front(), other)) {
            isReached_[other] = true;
            arrive(next.front(), other);
            next.push_back(other);
          }
  }

  /// Where rotations that differ are given side by side, nothing between them was found.
  [[nodiscard]] bool isPassable(Index a, Index b) const
  {
    return given_[a] < 0 || given_[b] < 0 || q_.row(a) == q_.row(b);
  }

  void arrive(Index from, Index to)
  {
    const Vector3 before = carried_.row(from);
    const Vector3 q = q_.row(to);
    const Vector3 carried = (q - before).norm() < kQuarterTurn ? q : rotationLogNear(rotationExp(q), before);
    carried_.row(to) = carried;
    if (given_[to] >= 0 && (carried - q).norm() > kHalfOfATurn)
      lost_.push_back(system_.rotations[given_[to]].constraint);
  }

  const ConstraintSystem& system_;
  const SolverMesh& mesh_;
  const Columns3& q_;
  IndexLists triangles_;
  std::vector<Index> given_;
  std::vector<bool> isReached_;
  Columns3 carried_;
  std::vector<Index> lost_;
};

/// The unit normal of each part that lies in a plane when it is displaced by `u`; 0 for others. n x 3.
Columns3 flatNormals(const SaddleTest& test)
{
  const SolverMesh& mesh = test.mesh;
  std::vector<std::vector<Index>> members(static_cast<std::size_t>(mesh.componentCount));
  for (Index i = 0; i < mesh.unknownCount(); ++i)
    if (mesh.componentOf[i] >= 0) members[mesh.componentOf[i]].push_back(i);
  Columns3 normals = Columns3::Zero(mesh.unknownCount(), 3);
  for (const std::vector<Index>& part : members) {
    Positions places = mesh.rest(part, Eigen::all) + test.u(part, Eigen::all);
    places.rowwise() -= places.colwise().mean().eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(places.transpose() * places);
    const Vector3 normal = axes.eigenvectors().col(0);
    if ((places * normal).cwiseAbs().maxCoeff() > test.flat * test.energy.size()) continue;
    for (const Index i : part) normals.row(i) = normal.transpose();
  }
  return normals;
}

/// The part of `x` along `normals`, row by row.
Columns3 partAlong(const Columns3& normals, const Columns3& x)
{
  return normals.array().colwise() * x.cwiseProduct(normals).rowwise().sum().array();
}

/// A push of everything to one side, more at one corner: some of every smooth mode is in it, and those give way first.
Columns3 pushTo(const Columns3& normals, const SolverMesh& mesh)
{
  const Vector3 across(1, 1 / std::numbers::phi, 1 / (std::numbers::phi * std::numbers::phi));
  Columns3 result = normals;
  for (Index i = 0; i < result.rows(); ++i)
    result.row(i) *= 1 + (mesh.rest.row(i) - mesh.rest.row(0)).dot(across) / mesh.diagonal;
  return result;
}

}  // namespace

std::optional<Finding> lostTurns(const ConstraintSystem& system, const SolverMesh& mesh, const Columns3& q)
{
  if (!haveTurns(system, mesh)) return std::nullopt;
  std::vector<Index> lost = CarriedLogs(system, mesh, q).lost();
  if (lost.empty()) return std::nullopt;
  const std::string what =
      "whole turns that the surface did not keep: the rotations that were found reach the same places with other "
      "turns; state the turns in steps, by handles between, or use given rotations";
  return makeFinding("turns_lost", "constraint", std::move(lost),
                     {"constraint states " + what, "constraints state " + what});
}

std::optional<Finding> overruledRotations(const ConstraintSystem& system, const Columns3& q)
{
  std::vector<Index> overruled;
  double largest = 0;
  for (const GivenRotation& given : system.rotations) {
    const Vector3 difference = q.row(given.unknown).transpose() - given.q;
    if (difference.norm() <= kTwoRotations) continue;
    overruled.push_back(given.constraint);
    largest = std::max(largest, angleDegrees(rotationLog(rotationExp(Vector3(q.row(given.unknown))) *
                                                         rotationExp(given.q).conjugate())));
  }
  if (overruled.empty()) return std::nullopt;
  const std::string what = fmt::format(
      "inside a rigid region whose points ask for another, up to {:.3g} degrees away: the points decide how the "
      "region rotates",
      largest);
  return makeFinding("rotations_overruled", "constraint", std::move(overruled),
                     {"constraint gives a rotation " + what, "constraints give rotations " + what});
}

std::optional<Finding> flatSaddle(const SaddleTest& test)
{
  const Columns3 normals = flatNormals(test);
  if (normals.isZero(0)) return std::nullopt;
  const Columns3 rest = test.next(test.u);
  const auto norm = [&](const Columns3& x) { return test.energy.A()->times(x).norm(); };
  Columns3 x = pushTo(normals, test.mesh);
  double growth = 0;
  for (int step = 0; step < kMostSaddleSteps && growth <= 1 + kGrowth; ++step) {
    const double size = x.rowwise().norm().maxCoeff();
    if (!(size > 0)) return std::nullopt;
    x *= kPush * test.energy.size() / size;
    const double before = norm(x);
    x = partAlong(normals, test.next(test.u + x) - rest);
    // The first step leads from anywhere to what constraints allow.
    if (step > 0) growth = norm(x) / before;
  }
  if (growth <= 1 + kGrowth) return std::nullopt;
  return Finding{"flat_saddle",
                 1,
                 "solution",
                 {},
                 "a flat part was pushed together and stayed flat, which is no minimum: it would bend to either side, "
                 "and nothing says to which; move a point of it a little out of its plane"};
}

}  // namespace holdfast
