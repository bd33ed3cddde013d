#include "holdfast/deform/solved_frame.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <holdfast/check/mesh_check.h>
#include <holdfast/deform/deformed_positions.h>
#include <holdfast/deform/determined_part.h>
#include <holdfast/deform/found_shape.h>
#include <holdfast/deform/messages.h>
#include <holdfast/deform/tolerance_offsets.h>
#include <holdfast/matrices/largest_size.h>
#include <holdfast/operators/model_size.h>
#include <holdfast/rotation/decided_rotations.h>
#include <holdfast/threads/parallel.h>
#include <holdfast/threads/stopwatch.h>

namespace holdfast {
namespace {

// A border by which fewer digits are left is not used.
constexpr double kBorderedAccuracy = 1e-8;

// Vertices that move by fewer diagonals leave doubles with the digits that the promised residual takes.
constexpr double kFarMove = 100;

/// The steps of one frame, in the order in which they stand here.
class FrameSolver {
 public:
  FrameSolver(const FrameProblem& problem, ConstraintFactorization& by, ConstraintSystem system)
      : problem_(problem), by_(by)
  {
    details_->labels = problem.labels;
    details_->operators = problem.operators.operators;
    details_->sensitivities = by.sensitivities;
    details_->system = std::move(system);
    report().weights = problem.options.weights;
    report().options = problem.options.solver;
    report().rotations = problem.options.rotations.source;
    result_.report.mesh = describeMesh(problem.model);
    result_.details = details_;
  }

  SolvedFrame solved(Progress& progress)
  {
    std::string refusal = turnRows(progress);
    diagnoseRows();
    if (!refusal.empty()) result_.rotations = Columns3::Zero(mesh().unknownCount(), 3);
    addFindings(guardFindings(*details_->operators, mesh()));
    addFindings(constraintFindings(problem_.model, *by_.eliminated, *details_));
    if (refusal.empty()) refusal = solve(progress);
    if (!refusal.empty()) refuse(refusal);
    if (std::optional<Finding> crowd = crowdedFinding(*details_)) addFindings({*std::move(crowd)});
    details_->diagnosis.targets = {};
    return {std::move(result_), neededDistance_};
  }

 private:
  /// Finds the field of rotations, and turns the rows that turn with it. Returns why that cannot be done, or nothing.
  std::string turnRows(Progress& progress)
  {
    if (!details_->operators->undefinedRows.empty()) return undefinedRowsMessage(problem_.model, *details_->operators);
    if (!by_.isForOneCall) {
      announceFactorization(progress);
      by_.positions.start(progress);  // beside the rotations
    }
    const bool isFactorised = by_.rotations->isReady();
    const Stopwatch time;
    if (!isFactorised) progress.step("solving the rotation field");
    Rotations rotations = by_.rotations->solve(details_->system, progress);
    (isFactorised ? report().seconds.solution : report().seconds.factorization) += time.seconds();
    if (by_.isForOneCall) by_.rotations.reset();
    takeOver(rotations, result_.report);
    if (!rotations.failure.empty()) return failureMessage(problem_.options, rotations.failure);
    details_->system = rotated(std::move(details_->system), rotations.q);
    result_.rotations = std::move(rotations.q);
    return {};
  }

  void announceFactorization(Progress& progress) const
  {
    if (!by_.positions.isDone()) progress.step(fmt::format("factorising {} unknowns", by_.eliminated->freeCount()));
  }

  void diagnoseRows()
  {
    details_->diagnosis = diagnose(*by_.eliminated, details_->system, mesh(), by_.knownGaps);
    if (!isFound() && result_.rotations.rows() > 0)
      details_->diagnosis.metIfFound = closedWhereFound(by_.eliminated->inAllDirections(), details_->system, mesh(),
                                                        details_->diagnosis, result_.rotations);
  }

  /// Returns why there is no solution, or nothing.
  std::string solve(Progress& progress)
  {
    if (!details_->system.tolerant.empty() && !isHard())
      return "points with tolerances or weights and points on other meshes are solved by hard constraints only; choose "
             "these, or make the points "
             "exact";
    const Stopwatch factorization;
    announceFactorization(progress);
    const AxisSolversResult& result = by_.positions.result(progress);
    report().seconds.factorization += factorization.seconds();
    if (!result) return failureMessage(problem_.options, result.failure);
    const AxisSolvers& solvers = *result.value;
    progress.step("solving");
    const Stopwatch solution;
    const SolvedDisplacement displacement = displacementBy(solvers, progress);
    if (!failure_.empty()) return failureMessage(problem_.options, failure_);
    for (const ConstraintNote& note : chosen_.notes) addFindings({noteFinding(note, *details_->labels)});
    report().unknowns = solvers.unknowns();
    report().factorNonzeros = solvers.factorNonzeros();
    report().method = solvers.method();
    report().refinementSteps = displacement.displacement->corrections;
    std::string reason = judgeDisplacement(solvers, *displacement.displacement);
    if (reason.empty()) {
      if (isHard()) details_->multipliers = multipliersOf(displacement);
      place(displacement.displacement->u);
      reason = judgeRows(displacement.displacement->u);
    }
    report().seconds.solution += solution.seconds();
    return reason.empty() ? reason : failureMessage(problem_.options, reason);
  }

  SolvedDisplacement displacementBy(const AxisSolvers& solvers, Progress& progress)
  {
    if (areSeparate(details_->system))
      prepareSeparate(progress);
    else if (!details_->system.tolerant.empty() && !areOfSameRows(by_.stiffness, details_->system))
      by_.stiffness = stiffnessOf(details_->system, solvers, *problem_.operators.A, by_.actedOn.get(), progress);
    if (isFound()) return findBy(solvers, progress);
    SolvedDisplacement stated = statedBy(solvers);
    if (details_->system.tolerant.empty()) return stated;
    auto chosen = std::make_shared<Displacement>(*stated.displacement);
    const bool wasReconciled = isReconciled(details_->diagnosis.targets);
    const bool hasFollowed = chooseTargetsAt(details_->system, solvers, *chosen, *stated.f, progress);
    diagnoseRows();
    details_->diagnosis.reasons = chosen_.contradictions;
    const std::vector<RowTargets>& targets = details_->diagnosis.targets;
    if (hasFollowed && !wasReconciled && !isReconciled(targets))
      solvers.meet(targets, chosen->u);
    else
      *chosen = solvers.solve(targets, *stated.f);
    return {std::move(chosen), std::move(stated.f)};
  }

  void prepareSeparate(Progress& progress)
  {
    if (by_.separate.rows == rowsOfTolerant(details_->system)) return;
    progress.step(fmt::format("preparing the places of {} points", details_->system.tolerant.size()));
    by_.separate = separatePlaces(details_->system, *by_.eliminated, problem_.operators.A);
  }

  /// Solves for the targets that rows have.
  SolvedDisplacement statedBy(const AxisSolvers& solvers)
  {
    if (!by_.moved.empty()) return movedBy(solvers);
    auto f = std::make_shared<const Columns3>(makeF());
    auto displacement = std::make_shared<const Displacement>(solvers.solve(details_->diagnosis.targets, *f));
    return {std::move(displacement), std::move(f)};
  }

  /// Chooses the targets of tolerant points. `displacement` is the solution for those that `system` has. Takes it to
  /// the chosen ones and returns true, where that costs no solution.
  bool chooseTargetsAt(ConstraintSystem& system, const AxisSolvers& solvers, Displacement& displacement,
                       const Columns3& f, Progress& progress)
  {
    const double scale = isFound() ? 1 : rowsInDiameters(problem_.options.weights, diameterInDiagonals(mesh()));
    const auto pullsAt = [&](const Columns3& u) -> Columns3 {
      return by_.eliminated->multipliers(
          forcesAtUnknowns(*problem_.operators.A, by_.actedOn.get(), u, f, mesh().diagonal));
    };
    if (areSeparate(system)) {
      if (by_.separate.failure.empty())
        failure_ = chooseSeparately(system, {solvers, by_.separate, mesh().diagonal, scale, f, pullsAt}, progress);
      else
        failure_ = by_.separate.failure;
      return false;
    }
    const Columns3 before = tolerantShifts(system);
    chosen_ = chooseTargets(system, {*by_.eliminated, by_.stiffness, mesh().diagonal, scale}, pullsAt(displacement.u));
    return followTargets(system, before, *by_.eliminated, by_.stiffness, displacement);
  }

  /// By the solutions before, part by part.
  SolvedDisplacement movedBy(const AxisSolvers& solvers)
  {
    std::vector<SolvedDisplacement> parts;
    Columns3 whole;  // f, made once for all parts that need it
    const auto along = [&](std::size_t k) {
      if (whole.rows() == 0) whole = makeF();
      return by_.eliminated->along(k, by_.moved.size() == 1 ? std::move(whole) : whole);
    };
    for (std::size_t k = 0; k < by_.moved.size(); ++k)
      parts.push_back(by_.moved[k].solve(solvers.of(k), details_->diagnosis.targets[k], result_.rotations,
                                         [&] { return along(k); }));
    if (parts.size() == 1) return std::move(parts.front());
    std::vector<Displacement> displacements;
    std::vector<Columns3> f;
    for (const SolvedDisplacement& part : parts) {
      displacements.push_back(*part.displacement);
      f.push_back(*part.f);
    }
    return {std::make_shared<const Displacement>(solvers.joined(std::move(displacements))),
            std::make_shared<const Columns3>(by_.eliminated->joined(std::move(f)))};
  }

  [[nodiscard]] Columns3 makeF() const
  {
    const Eigen::VectorXd& weights = details_->operators->rowWeights;
    Columns3 f = rotationOfDelta(details_->operators->delta, result_.rotations);
    parallelBlocks(f.rows(), [&](Index i) { f.row(i) *= mesh().diagonal * weights[i]; });
    return f;
  }

  SolvedDisplacement findBy(const AxisSolvers& solvers, Progress& progress)
  {
    RotationOptions options = problem_.options.rotations;
    if (problem_.before != nullptr) options.mostIterations = kIterationsOfFrame;
    FoundProblem problem{*problem_.operators.energy, mesh(), solvers, {}};
    if (!details_->system.tolerant.empty())
      problem.chooseTargets = [&](ConstraintSystem& system, Displacement& displacement, const Columns3& f) {
        return chooseTargetsAt(system, solvers, displacement, f, progress);
      };
    FoundShape shape = findShape(
        problem, std::move(details_->system),
        {std::move(result_.rotations), problem_.before == nullptr ? Columns3() : *problem_.before}, options, progress);
    report().iterations = shape.iterations;
    if (!shape.iterations.isConverged && problem_.before == nullptr)
      addFindings({unconvergedWarning(shape.iterations, options)});
    result_.rotations = std::move(shape.q);
    details_->system = std::move(shape.system);
    diagnoseRows();
    details_->diagnosis.reasons = std::move(shape.reasons);
    details_->diagnosis.reasons.merge(chosen_.contradictions);
    addFindings(std::move(shape.findings));
    return {std::make_shared<const Displacement>(std::move(shape.displacement)),
            std::make_shared<const Columns3>(std::move(shape.wanted))};
  }

  /// Measures how accurate the displacement is, in the part that constraints determine and in the part that they leave
  /// free. Only `Hard` tells these apart. Returns why the displacement is no solution, or nothing. Warns of a doubtful
  /// one.
  std::string judgeDisplacement(const AxisSolvers& solvers, const Displacement& displacement)
  {
    if (by_.isBordered && displacement.accuracy > kBorderedAccuracy) return "the border leaves too few digits";
    if (!std::isfinite(largestSize(displacement.u)))
      return farOff(displacement.u, "the solution is not finite: the problem is singular in doubles");
    const DeterminedPart determined = isHard() ? determinedPart(details_->system, *details_->sensitivities, solvers,
                                                                details_->diagnosis.targets, displacement.u)
                                               : DeterminedPart{};
    report().accuracy = std::max(displacement.accuracy, determined.accuracy);
    const bool isOfRows = determined.accuracy > displacement.accuracy;
    const std::optional<Finding> warning = isOfRows
                                               ? determinedWarning(*details_, determined)
                                               : accuracyWarning("low_accuracy", "the solution", displacement.accuracy);
    if (warning) addFindings({*warning});
    const std::string failure =
        isOfRows ? determinedFailure(*details_, determined) : accuracyFailure(displacement.accuracy);
    return failure.empty() ? failure : farOff(displacement.u, "the solution cannot be used: " + failure);
  }

  /// `reason`, where it may be that rows nearly depend on others: notes what distance would keep `u` near. An
  /// inconsistency moves vertices by its size times the largest sensitivity.
  std::string farOff(const Columns3& u, std::string reason)
  {
    if (!isHard()) return reason;
    const double moved = largestSize(u) / mesh().diagonal;
    const double distance = moved / (kFarMove * by_.largestSensitivity());
    neededDistance_ = std::isfinite(distance) ? std::max(distance, kRankTolerance) : kRankTolerance;
    return reason;
  }

  /// Forces are made whenever somebody asks for them: nothing that they are made of changes.
  [[nodiscard]] std::shared_future<Multipliers> multipliersOf(SolvedDisplacement solved) const
  {
    return std::async(std::launch::deferred,
                      [A = problem_.operators.A, actedOn = by_.actedOn, eliminated = by_.eliminated,
                       diagonal = mesh().diagonal, solved = std::move(solved)]() mutable {
                        const SolvedDisplacement its = std::exchange(solved, {});  // not to be kept beside the forces
                        Columns3 forces = forcesAtUnknowns(*A, actedOn.get(), its.displacement->u, *its.f, diagonal);
                        return Multipliers{eliminated->multipliers(forces), std::move(forces)};
                      });
  }

  /// The elimination copies pins. What the other solvers find is measured as they find it.
  void place(const Columns3& u)
  {
    result_.positions = isHard() ? deformedPositions(problem_.model, details_->system, details_->diagnosis, u)
                                 : deformedPositions(problem_.model, {}, {}, u);
  }

  /// Residuals, limits and statuses of all rows at the positions. Returns why hard constraints are missed, or nothing.
  std::string judgeRows(const Columns3& u)
  {
    Diagnosis& diagnosis = details_->diagnosis;
    if (!diagnosis.isNearOrigin) diagnosis.limits = residualLimits(mesh(), details_->system, diagnosis.dependent, u);
    details_->residuals = rowResiduals(details_->system, mesh().weld, result_.positions);
    details_->isSolved = true;
    if (isHard()) judgeUndecided();
    tellOutcomes();
    const std::optional<MissedRow> worst = setLargestResidual(result_.report, *details_, details_->residuals);
    report().status = diagnosis.hasConflicts() ? SolveStatus::Conflicts : SolveStatus::Ok;
    report().message = solvedMessage(result_.report, worst);
    return isHard() && worst ? farOff(u, missedMessage(result_.report, *worst)) : "";
  }

  /// Rows too close to depending on others to be held with them hold where the solution happens to meet them.
  void judgeUndecided()
  {
    Diagnosis& diagnosis = details_->diagnosis;
    for (DependentRow& row : diagnosis.dependent) {
      if (!row.dependency.isUndecided()) continue;
      RowStatus& status = diagnosis.status[row.dependency.row];
      row.isConflicting = isMissed(*details_, row.dependency.row);
      if (row.isConflicting)
        status = RowStatus::Conflicting;
      else if (status == RowStatus::Conflicting)
        status = RowStatus::Redundant;
    }
  }

  /// Makes the shape at rest the result. The report names no residuals then, because the solution is discarded.
  void refuse(const std::string& message)
  {
    report().status = SolveStatus::Failed;
    report().message = message;
    result_.positions = problem_.model.mesh.positions;
    details_->residuals = rowResiduals(details_->system, mesh().weld, result_.positions);
    details_->isSolved = false;
    details_->multipliers = {};
    tellOutcomes();
  }

  /// They are made of the details as these are when somebody first looks.
  void tellOutcomes()
  {
    result_.report.constraints = ConstraintOutcomes([details = result_.details] {
      return outcomes(*details, details->isSolved ? details->residuals : std::vector<double>());
    });
  }

  void addFindings(std::vector<Finding> some)
  {
    std::vector<Finding>& findings = result_.report.mesh.findings;
    findings.insert(findings.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  }

  [[nodiscard]] SolveReport& report() { return result_.report.solve; }
  [[nodiscard]] const SolverMesh& mesh() const { return problem_.model.solverMesh; }
  [[nodiscard]] bool isHard() const { return problem_.options.solver.kind == SolverKind::Hard; }
  [[nodiscard]] bool isFound() const { return problem_.operators.energy != nullptr; }

  const FrameProblem& problem_;
  ConstraintFactorization& by_;
  std::shared_ptr<DeformDetails> details_ = std::make_shared<DeformDetails>();
  DeformResult result_;
  double neededDistance_ = 0;
  ChosenPlaces chosen_;
  std::string failure_;  // why there are no places
};

}  // namespace

SolvedFrame solveFrame(const FrameProblem& problem, ConstraintSystem system, ConstraintFactorization& by,
                       Progress& progress)
{
  return FrameSolver(problem, by, std::move(system)).solved(progress);
}

}  // namespace holdfast
