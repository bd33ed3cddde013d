#include "holdfast/deform/deformer.h"

#include <utility>

#include <fmt/format.h>

#include <holdfast/base/stopwatch.h>
#include <holdfast/constraints/carried_vectors.h>
#include <holdfast/deform/accuracy.h>
#include <holdfast/deform/constraint_findings.h>
#include <holdfast/deform/forces.h>
#include <holdfast/deform/messages.h>
#include <holdfast/deform/outcomes.h>

namespace holdfast {
namespace {

/// The file's positions: pins as they were asked for, bit for bit, everything else displaced from rest.
Positions deformedPositions(const Model& model, const ConstraintSystem& system, const Diagnosis& diagnosis,
                            const Columns3& u)
{
  const std::vector<Index>& unknownOf = model.solverMesh.weld.unknownOf;
  std::vector<Index> pinOf(static_cast<std::size_t>(model.solverMesh.unknownCount()), -1);
  for (Index r = static_cast<Index>(system.rows.size()) - 1; r >= 0; --r)
    if (system.rows[r].isPin() && diagnosis.status[r] != RowStatus::Conflicting)
      pinOf[system.rows[r].terms.front().vertex] = r;
  Positions positions = model.mesh.positions;
  for (Index v = 0; v < positions.rows(); ++v) {
    const Index unknown = unknownOf[v];
    if (pinOf[unknown] >= 0)
      positions.row(v) = system.rows[pinOf[unknown]].target;
    else if (!u.row(unknown).isZero(0))
      positions.row(v) += u.row(unknown);
  }
  return positions;
}

/// One solution by a decomposition, and what is to be said of it.
class Solution {
 public:
  Solution(const Model& model, const ConstraintList& constraints, const DeformOptions& options,
           std::shared_ptr<const Operators> operators, ConstraintSystem system)
      : model_(model), constraints_(constraints), options_(options)
  {
    result_.operators = std::move(operators);
    result_.system = std::move(system);
    result_.positions = model.mesh.positions;
    result_.rotations = Columns3::Zero(model.solverMesh.unknownCount(), 3);
    result_.report.mesh = describeMesh(model);
    report().weights = options.weights;
    report().options = options.solver;
  }

  /// Everything but the seconds that went before.
  Deformation by(Decomposition& decomposition, Progress& progress)
  {
    diagnoseRows(decomposition);
    if (result_.operators->undefinedRows.empty())
      rotate(decomposition, progress);
    else
      refuse(undefinedRowsMessage(model_, *result_.operators));
    addFindings(decomposition.eliminated());
    if (report().status != SolveStatus::Failed) solve(decomposition, progress);
    return std::move(result_);
  }

 private:
  [[nodiscard]] SolveReport& report() { return result_.report.solve; }

  /// Numbers went wrong, and other options may help.
  void fail(const std::string& reason) { refuse(failureMessage(options_, reason)); }

  void refuse(const std::string& message)
  {
    report().status = SolveStatus::Failed;
    report().message = message;
    result_.positions = model_.mesh.positions;
    // Residuals of positions that nobody gets would be misleading.
    for (ConstraintOutcome& outcome : result_.report.constraints) {
      outcome.residual.reset();
      if (outcome.status == ConstraintStatus::Met || outcome.status == ConstraintStatus::Missed)
        outcome.status = ConstraintStatus::Independent;
    }
  }

  void diagnoseRows(const Decomposition& decomposition)
  {
    result_.diagnosis = diagnose(decomposition.eliminated(), result_.system, model_.solverMesh);
    result_.report.constraints = outcomes(constraints_, result_.system, result_.diagnosis);
    setAmplifications(result_.report.constraints, result_.system, result_.diagnosis, decomposition.amplifications());
  }

  /// Finds the rotations and what they make of the rows.
  void rotate(Decomposition& decomposition, Progress& progress)
  {
    const bool isFactorised = decomposition.hasRotationFactor();
    const Stopwatch stopwatch;
    Rotations rotations = decomposition.rotations(result_.system, progress);
    Seconds& seconds = report().seconds;
    (isFactorised ? seconds.solution : seconds.decomposition) += stopwatch.seconds();
    takeOver(rotations, result_.report);
    if (!rotations.failure.empty()) return fail(rotations.failure);
    if (rotations.q.isZero(0)) return;
    result_.system = turned(std::move(result_.system), rotations.q);
    result_.rotations = std::move(rotations.q);
    diagnoseRows(decomposition);
  }

  void addFindings(const EliminatedConstraints& eliminated)
  {
    std::vector<Finding>& findings = result_.report.mesh.findings;
    for (Finding& finding : guardFindings(*result_.operators, model_.solverMesh))
      findings.push_back(std::move(finding));
    for (Finding& finding : constraintFindings(model_, eliminated, result_.system, result_.report.constraints))
      findings.push_back(std::move(finding));
  }

  void solve(Decomposition& decomposition, Progress& progress)
  {
    const Stopwatch factorization;
    const DecompositionAttempt& attempt = decomposition.positions(progress);
    report().seconds.decomposition += factorization.seconds();
    if (attempt.solver == nullptr) return fail(attempt.failure);
    report().unknowns = attempt.solver->unknowns();
    report().factorNonzeros = attempt.solver->factorNonzeros();
    report().method = attempt.solver->method();

    progress.stage("solving");
    const Stopwatch solution;
    const Columns3 f = turnedDetail(*result_.operators, result_.rotations, model_.solverMesh.diagonal);
    const Displacement displacement =
        attempt.solver->solve({shiftsOf(result_.system), result_.diagnosis.reconciled}, f);
    accept(displacement);
    if (options_.solver.kind == SolverKind::Hard && report().status != SolveStatus::Failed)
      weigh(forcesOf(*result_.operators, decomposition.eliminated(), displacement.u, f, model_.solverMesh.diagonal));
    report().seconds.solution += solution.seconds();
  }

  void weigh(Forces forces)
  {
    const std::vector<double> ofConstraints =
        forcesOfConstraints(forces, result_.system, result_.report.constraints.size());
    for (std::size_t c = 0; c < ofConstraints.size(); ++c)
      if (result_.report.constraints[c].rows > 0) result_.report.constraints[c].force = ofConstraints[c];
    result_.forces = std::move(forces.ofUnknowns);
  }

  /// Takes the solution over when it is one.
  void accept(const Displacement& displacement)
  {
    report().refinementSteps = displacement.corrections;
    report().accuracy = displacement.accuracy;
    if (!displacement.u.allFinite()) return fail("the solution is not finite: the problem is singular in doubles");
    if (const std::string failure = accuracyFailure(displacement.accuracy); !failure.empty())
      return fail("the solution cannot be used: " + failure);
    if (const auto warning = accuracyWarning("low_accuracy", "the solution", displacement.accuracy))
      result_.report.mesh.findings.push_back(*warning);
    // The elimination copies pins. What the other solvers find is measured as they find it.
    const bool isEliminated = options_.solver.kind == SolverKind::Hard;
    result_.positions = isEliminated ? deformedPositions(model_, result_.system, result_.diagnosis, displacement.u)
                                     : deformedPositions(model_, {}, {}, displacement.u);
    judge();
  }

  void judge()
  {
    const SolverMesh& mesh = model_.solverMesh;
    result_.diagnosis.limits = residualLimits(mesh, result_.system, result_.diagnosis.dependent,
                                              result_.positions(mesh.weld.firstVertexOf, Eigen::all));
    const std::optional<MissedRow> worst = setResiduals(result_.report, result_.system, result_.diagnosis,
                                                        rowResiduals(result_.system, mesh.weld, result_.positions));
    report().status = result_.diagnosis.hasConflicts() ? SolveStatus::Conflicts : SolveStatus::Ok;
    report().message = solvedMessage(result_.report, worst);
    if (options_.solver.kind == SolverKind::Hard && worst) fail(missedMessage(result_.report, *worst));
  }

  const Model& model_;
  const ConstraintList& constraints_;
  const DeformOptions& options_;
  Deformation result_;
};

}  // namespace

Deformer::Deformer(const Model& model, const DeformOptions& options) : model_(model), options_(options) {}

Deformation Deformer::deform(const ConstraintList& constraints, const std::string& source, Progress& progress)
{
  Seconds seconds;
  const Stopwatch setup;
  ConstraintSystem system =
      makeConstraintSystem(constraints, model_.mesh, model_.triangulation, model_.solverMesh, source);
  if (operators_ == nullptr) {
    progress.stage(fmt::format("building operators of {} vertices", model_.mesh.vertexCount()));
    operators_ = std::make_shared<const Operators>(makeOperators(model_.solverMesh, options_.weights));
  }
  seconds.setup = setup.seconds();

  const Stopwatch elimination;
  if (decomposition_ == nullptr || !decomposition_->serves(system)) {
    progress.stage(fmt::format("eliminating {} rows of constraints", system.rows.size()));
    decomposition_ = std::make_unique<Decomposition>(model_, operators_, system, options_);
  }
  seconds.decomposition = elimination.seconds();

  Deformation result =
      Solution(model_, constraints, options_, operators_, std::move(system)).by(*decomposition_, progress);
  result.report.solve.seconds.setup = seconds.setup;
  result.report.solve.seconds.decomposition += seconds.decomposition;
  return result;
}

}  // namespace holdfast
