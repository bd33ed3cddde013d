#include "holdfast/deform/found_shape.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <utility>

#include <Eigen/QR>
#include <fmt/format.h>

#include <holdfast/deform/found_findings.h>
#include <holdfast/geometry/rotation_fit.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/rotation/decided_rotations.h>

namespace holdfast {
namespace {

using RotationKind = FreeRotations::Kind;

/// Logs of `R`, the nearest to those of `q`; where they are given, those.
Columns3 logsNear(const UnknownRotations& R, const FreeRotations& free, Columns3 q)
{
  parallelBlocks(q.rows(), [&](Index i) {
    if (free.kindOf[i] != RotationKind::Given) q.row(i) = rotationLogNear(R[i], Vector3(q.row(i)));
  });
  return q;
}

double largestChange(const Columns3& u, const Columns3& before)
{
  return u.size() == 0 ? 0 : (u - before).rowwise().norm().maxCoeff();
}

/// Returns, for each part without a given rotation, the log of the one that best takes points to their targets; 0 for
/// others.
std::vector<Vector3> fittedParts(const ConstraintSystem& system, const SolverMesh& mesh)
{
  std::vector<char> isGiven(static_cast<std::size_t>(mesh.componentCount));
  for (const GivenRotation& given : system.rotations)
    if (const Index part = mesh.componentOf[given.unknown]; part >= 0) isGiven[part] = 1;
  std::vector<std::vector<Index>> rowsOf(isGiven.size());
  for (std::size_t r = 0; r < system.rows.size(); ++r) {
    const ConstraintRow& row = system.rows[r];
    const bool isPlace = row.kind == RowKind::Position && row.directions.areAll();
    const Index part = isPlace ? mesh.componentOf[row.terms.front().index] : -1;
    if (part >= 0 && isGiven[part] == 0) rowsOf[part].push_back(static_cast<Index>(r));
  }
  std::vector<Vector3> result(isGiven.size(), Vector3::Zero());
  for (std::size_t part = 0; part < rowsOf.size(); ++part) {
    const auto count = static_cast<Index>(rowsOf[part].size());
    Positions points(count, 3);
    Positions targets(count, 3);
    for (Index k = 0; k < count; ++k) {
      const ConstraintRow& row = system.rows[rowsOf[part][k]];
      points.row(k) = row.target - row.shift;
      targets.row(k) = row.target;
    }
    if (points != targets) result[part] = rotationLog(fitRotation(points, targets).R);
  }
  return result;
}

/// Returns the rotations that were found before, where there are any; else those of the field. A part without a given
/// rotation gets the one that best takes points of constraints to their targets, so that a motion of all of them costs
/// nothing.
Columns3 startRotations(const ConstraintSystem& system, const SolverMesh& mesh, const FreeRotations& free,
                        RotationStart&& from)
{
  auto& [q, before] = from;
  const std::vector<Vector3> ofPart = fittedParts(system, mesh);
  for (Index i = 0; i < q.rows(); ++i) {
    const Index part = mesh.componentOf[i];
    if (before.rows() > 0 && free.kindOf[i] != RotationKind::Given)
      q.row(i) = before.row(i);
    else if (part >= 0 && !ofPart[part].isZero(0))
      q.row(i) = ofPart[part];
  }
  return std::move(q);
}

/// The first point that a constraint places within each region: none where there is none.
std::vector<RegionHold> placedPoints(const ConstraintSystem& system, const TurningBodies& bodies, const Positions& rest)
{
  std::vector<RegionHold> holds(bodies.bodies.size());
  for (const ConstraintRow& row : system.rows) {
    if (row.kind != RowKind::Position || !row.directions.areAll()) continue;
    const Index body = bodies.bodyOfUnknown[row.terms.front().index];
    const auto isOutside = [&](const Term& term) { return bodies.bodyOfUnknown[term.index] != body; };
    if (body < 0 || holds[body].kind != RegionHold::Kind::None || std::ranges::any_of(row.terms, isOutside)) continue;
    holds[body] = {RegionHold::Kind::AtPlace, Vector3::Zero(), row.target, Vector3::Zero()};
    for (const Term& term : row.terms) holds[body].rest += term.coefficient * rest.row(term.index).transpose();
  }
  return holds;
}

/// What constraints leave each free region to turn by.
std::vector<RegionHold> holdsOf(const std::vector<std::vector<Index>>& regions, const DecidedRotations& decided,
                                const ConstraintSystem& system, const Positions& rest)
{
  const TurningBodies& bodies = decided.bodies();
  const std::vector<RegionHold> placed = placedPoints(system, bodies, rest);
  std::vector<RegionHold> holds;
  for (const std::vector<Index>& region : regions) {
    const Index body = bodies.bodyOfUnknown[region.front()];
    const TurningFreedom freedom = decided.freedomOf(body);
    RegionHold& hold = holds.emplace_back(placed[body]);
    if (freedom == TurningFreedom::None) hold.kind = RegionHold::Kind::Whole;
    if (freedom != TurningFreedom::AboutAxis || hold.kind == RegionHold::Kind::None) continue;
    hold.kind = RegionHold::Kind::AboutAxis;
    hold.axis = decided.axisOf(body);
  }
  return holds;
}

/// Solves from `near`, which has no numbers where nothing is known.
Displacement solvedNear(const Displacement& near, const AxisSolvers& solvers, const std::vector<RowTargets>& targets,
                        const Columns3& f)
{
  return near.u.size() == 0 ? solvers.solve(targets, f) : solvers.solveFrom(Displacement(near), targets, f);
}

/// Anderson's acceleration (1965) of an iteration u <- g(u): goes on from the combination of the last few results for
/// which the same combination of changes g(u) - u is shortest.
class Acceleration {
 public:
  [[nodiscard]] Columns3 next(const Columns3& u, const Columns3& g)
  {
    if (results_.size() == kMostKept) {
      changes_.pop_front();
      results_.pop_front();
      products_ = products_.bottomRightCorner(kMostKept - 1, kMostKept - 1).eval();
    }
    changes_.push_back(g - u);
    results_.push_back(g);
    const auto count = static_cast<Index>(results_.size());
    products_.conservativeResize(count, count);
    for (Index k = 0; k < count; ++k)
      products_(k, count - 1) = products_(count - 1, k) = changes_[k].cwiseProduct(changes_.back()).sum();
    const Eigen::VectorXd weights = products_.completeOrthogonalDecomposition().solve(Eigen::VectorXd::Ones(count));
    const double sum = weights.sum();
    if (!(std::isfinite(sum) && sum > 0)) return g;
    Columns3 result = g;
    for (Index k = 0; k + 1 < count; ++k) result += weights[k] / sum * (results_[k] - g);
    return result;
  }

  /// Tells whether the last was a combination.
  [[nodiscard]] bool isCombined() const { return results_.size() > 1; }

  void forget()
  {
    changes_.clear();
    results_.clear();
    products_.resize(0, 0);
  }

 private:
  // More gain little, and each is two more shapes in memory.
  static constexpr std::size_t kMostKept = 6;
  std::deque<Columns3> changes_;
  std::deque<Columns3> results_;
  Eigen::MatrixXd products_;  // of changes with one another
};

/// Tells of iterations that are powers of two; there may be many.
void announce(const RotationIterations& iterations, Progress& progress)
{
  const auto count = static_cast<unsigned>(iterations.count);
  if (count == 0)
    progress.step("finding rotations");
  else if (std::has_single_bit(count))
    progress.step(fmt::format("finding rotations: iteration {}, last change {:.1e}", count + 1, iterations.change));
  else
    progress.proceed(0);
}

}  // namespace

FoundShape findShape(const FoundProblem& problem, ConstraintSystem system, RotationStart start,
                     const RotationOptions& options, Progress& progress)
{
  FreeRotations free(system, problem.mesh.unknownCount());
  const bool turnsRows = !system.rotated.empty();
  const bool isNew = start.before.rows() == 0;
  FoundShape shape;
  shape.q = startRotations(system, problem.mesh, free, std::move(start));
  const EliminatedByAxes& eliminated = problem.solvers.eliminated();
  DecidedRotations decided(eliminated.inAllDirections(), system, problem.mesh);
  decided.settle(system, shape.q);
  if (turnsRows) free.holds = holdsOf(free.regions, decided, system, problem.mesh.rest);
  shape.system = std::move(system);
  UnknownRotations R(static_cast<std::size_t>(shape.q.rows()));
  parallelBlocks(shape.q.rows(), [&](Index i) { R[i] = rotationExp(Vector3(shape.q.row(i))); });

  std::vector<RowTargets> targets;
  const auto solved = [&] {
    if (turnsRows) shape.system = decided.withTurnedVectors(rotated(std::move(shape.system), shape.q));
    if (turnsRows || targets.empty()) targets = diagnose(eliminated, shape.system, problem.mesh).targets;
    shape.wanted = problem.energy.wanted(R);
    Displacement next = solvedNear(shape.displacement, problem.solvers, targets, shape.wanted);
    if (!problem.chooseTargets) return next;
    const bool hasFollowed = problem.chooseTargets(shape.system, next, shape.wanted);
    const bool wasReconciled = isReconciled(targets);
    targets = diagnose(eliminated, shape.system, problem.mesh).targets;
    if (!hasFollowed || wasReconciled || isReconciled(targets))
      return solvedNear(next, problem.solvers, targets, shape.wanted);
    problem.solvers.meet(targets, next.u);
    return next;
  };
  shape.displacement = solved();
  Acceleration acceleration;
  Columns3 from = shape.displacement.u;
  bool isCombined = false;  // `from`: of several shapes
  double energy = problem.energy.value(from, R);
  auto& [count, change, isConverged] = shape.iterations;
  const auto iterate = [&] {
    R = problem.energy.fitted(from, free, std::move(R));
    if (turnsRows) {
      shape.q = logsNear(R, free, std::move(shape.q));
      decided.settle(shape.system, shape.q);
      for (const TurningBody* body : decided.turnedBodies())
        for (const Index unknown : body->unknowns) R[unknown] = rotationExp(Vector3(shape.q.row(unknown)));
    }
    return solved();
  };
  while (!isConverged && count < options.mostIterations && shape.displacement.u.allFinite()) {
    announce(shape.iterations, progress);
    Displacement next = iterate();
    double itsEnergy = problem.energy.value(next.u, R);
    if (isCombined && !(itsEnergy <= energy)) {
      acceleration.forget();
      from = std::move(shape.displacement.u);
      next = iterate();
      itsEnergy = problem.energy.value(next.u, R);
    }
    shape.displacement = std::move(next);
    energy = itsEnergy;
    const Columns3& u = shape.displacement.u;
    change = largestChange(u, from) / problem.energy.size();
    from = acceleration.next(from, u);
    isCombined = acceleration.isCombined();
    ++count;
    isConverged = change <= options.change;
  }
  shape.q = logsNear(R, free, std::move(shape.q));
  shape.reasons = decided.reasons();
  if (isNew && isConverged) {
    const auto add = [&](const std::optional<Finding>& finding) {
      if (finding) shape.findings.push_back(*finding);
    };
    add(lostTurns(shape.system, problem.mesh, shape.q));
    add(overruledRotations(shape.system, shape.q));
    const auto next = [&](const Columns3& u) {
      return problem.solvers.solve(targets, problem.energy.wanted(problem.energy.fitted(u, free, R))).u;
    };
    if (change > 0) add(flatSaddle({problem.energy, problem.mesh, shape.displacement.u, options.change, next}));
  }
  return shape;
}

}  // namespace holdfast
