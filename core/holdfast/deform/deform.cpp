#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include <holdfast/constraints/carried_vectors.h>
#include <holdfast/deform/deform.h>
#include <holdfast/deform/forces.h>
#include <holdfast/deform/outcomes.h>
#include <holdfast/deform/rotation_stage.h>

namespace holdfast {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

// Solutions less accurate than this are no answer.
constexpr double kUsableAccuracy = 1e-6;

std::vector<Finding> constraintFindings(const Model& model, const EliminatedConstraints& eliminated)
{
  std::vector<Index> atRest(static_cast<std::size_t>(model.solverMesh.componentCount), -1);
  for (Index u = 0; u < model.solverMesh.unknownCount(); ++u)
    if (const Index c = model.solverMesh.componentOf[u]; c >= 0 && eliminated.isHeld[u] && atRest[c] < 0)
      atRest[c] = model.solverMesh.weld.firstVertexOf[u];
  std::erase(atRest, -1);
  if (atRest.empty()) return {};
  return {makeFinding("parts_at_rest", "vertex", std::move(atRest),
                      "connected parts have no constraint and stay at rest (a vertex of each is named)")};
}

/// What is doubtful about single constraints, a finding for each.
void addNotes(Report& report, const ConstraintList& constraints, const ConstraintSystem& system)
{
  for (const ConstraintNote& note : system.notes)
    report.mesh.findings.push_back(
        {note.kind,
         1,
         "constraint",
         {note.constraint},
         fmt::format("\"{}\" {}", constraints.constraints[note.constraint].name, note.message)});
}

/// Constraints that nearly repeat others.
void addConstraintFindings(Report& report)
{
  std::vector<Index> amplified;
  double largest = 0;
  for (std::size_t c = 0; c < report.constraints.size(); ++c)
    if (report.constraints[c].amplification.value_or(0) > kLargeAmplification) {
      amplified.push_back(static_cast<Index>(c));
      largest = std::max(largest, *report.constraints[c].amplification);
    }
  if (amplified.empty()) return;
  report.mesh.findings.push_back(makeFinding(
      "nearly_dependent_constraints", "constraint", std::move(amplified),
      fmt::format("constraints nearly follow from others: a unit of inconsistency moves vertices by up to {:.2g} "
                  "units; move their points apart, or leave some out",
                  largest)));
}

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

std::string undefinedRowsMessage(const Model& model, const Operators& operators)
{
  return fmt::format(
      "the weights \"{}\" are not finite at {} vertices, the first of them vertex {}, because a face there has no "
      "area; "
      "use the weights \"cotangent\", which are guarded against that, or repair those faces",
      name(operators.weights), operators.undefinedRows.size(),
      model.solverMesh.weld.firstVertexOf[operators.undefinedRows.front()]);
}

std::string failureMessage(const SolverOptions& options, Weights weights, const std::string& reason)
{
  std::string remedy;
  if (weights != Weights::Cotangent) remedy = "; the default weights \"cotangent\" are guarded against bad triangles";
  if (options.kind != SolverKind::Hard) remedy += "; the solver \"hard\" is better conditioned";
  return reason + remedy;
}

std::string solvedMessage(const Deformation& result, double limit)
{
  const auto conflicting = std::count_if(result.report.constraints.begin(), result.report.constraints.end(),
                                         [](const auto& c) { return c.status == ConstraintStatus::Conflicting; });
  const auto missed = std::count_if(result.report.constraints.begin(), result.report.constraints.end(),
                                    [](const auto& c) { return c.status == ConstraintStatus::Missed; });
  if (missed > 0 && conflicting > 0)
    return fmt::format(
        "a compromise: {} of {} constraints conflict with earlier ones, and the {} solver meets neither them nor {} "
        "others, but only comes near all (beyond {:.3g})",
        conflicting, result.report.constraints.size(), name(result.report.solve.options.kind), missed, limit);
  if (missed > 0)
    return fmt::format(
        "{} of {} constraints are met only approximately (beyond {:.3g}), as is the nature of the {} solver", missed,
        result.report.constraints.size(), limit, name(result.report.solve.options.kind));
  if (conflicting > 0)
    return fmt::format(
        "{} of {} constraints conflict with earlier ones and were left out where they do; all others are met",
        conflicting, result.report.constraints.size());
  return "all constraints are met";
}

/// Of hard constraints that cannot be kept in doubles: which, by how much, and what to do.
std::string missedMessage(const Report& report, double limit)
{
  const auto worst = std::find_if(report.constraints.begin(), report.constraints.end(), [&](const auto& outcome) {
    return outcome.status == ConstraintStatus::Missed && outcome.residual == report.solve.maxResidual;
  });
  const std::string name = worst == report.constraints.end() ? "a constraint" : '"' + worst->name + '"';
  return fmt::format(
      "{} is missed by {:.3g}, more than the promised {:.3g}, because constraints beside it nearly repeat it and ask "
      "for something else; leave one of them out, or move them apart",
      name, report.solve.maxResidual, limit);
}

/// One run of `deform`, stage by stage.
class Run {
 public:
  Run(const Model& model, const ConstraintList& constraints, const std::string& source, const DeformOptions& options,
      Progress& progress)
      : model_(model), constraints_(constraints), source_(source), options_(options), progress_(progress)
  {
  }

  Deformation run()
  {
    setUp();
    decomposeAndSolve();
    return std::move(result_);
  }

 private:
  [[nodiscard]] SolveReport& solve() { return result_.report.solve; }

  /// Numbers went wrong, and other options may help.
  void fail(const std::string& reason) { refuse(failureMessage(options_.solver, options_.weights, reason)); }

  void refuse(const std::string& message)
  {
    solve().status = SolveStatus::Failed;
    solve().message = message;
    result_.positions = model_.mesh.positions;
    // Residuals of positions that nobody gets would be misleading.
    for (ConstraintOutcome& outcome : result_.report.constraints) {
      outcome.residual.reset();
      if (outcome.status == ConstraintStatus::Met || outcome.status == ConstraintStatus::Missed)
        outcome.status = ConstraintStatus::Independent;
    }
  }

  void setUp()
  {
    progress_.stage(fmt::format("building operators of {} vertices", model_.mesh.vertexCount()));
    const Stopwatch stopwatch;
    result_.report.mesh = describeMesh(model_);
    solve().weights = options_.weights;
    solve().options = options_.solver;
    result_.operators = makeOperators(model_.solverMesh, options_.weights);
    result_.system = makeConstraintSystem(constraints_, model_.mesh, model_.triangulation, model_.solverMesh, source_);
    solve().seconds.setup = stopwatch.seconds();
  }

  void addFindings(const EliminatedConstraints& eliminated)
  {
    std::vector<Finding>& findings = result_.report.mesh.findings;
    for (Finding& finding : guardFindings(result_.operators, model_.solverMesh)) findings.push_back(std::move(finding));
    for (Finding& finding : constraintFindings(model_, eliminated)) findings.push_back(std::move(finding));
  }

  void decomposeAndSolve()
  {
    progress_.stage(fmt::format("eliminating {} rows of constraints", result_.system.rows.size()));
    const Stopwatch stopwatch;
    const EliminatedConstraints eliminated = eliminate(result_.system, model_.solverMesh);
    addFindings(eliminated);
    result_.rotations = Columns3::Zero(model_.solverMesh.unknownCount(), 3);
    diagnoseRows(eliminated);
    if (!result_.operators.undefinedRows.empty()) return refuse(undefinedRowsMessage(model_, result_.operators));
    if (!rotate()) return;
    diagnoseRows(eliminated);
    addConstraintFindings(result_.report);
    addNotes(result_.report, constraints_, result_.system);

    progress_.stage(fmt::format("factorising {} unknowns", eliminated.elimination.Q2().cols()));
    const SparseMatrix A = weightedRows(result_.operators);
    const Columns3 centred = model_.solverMesh.rest.rowwise() - model_.solverMesh.rest.colwise().mean();
    DecompositionAttempt attempt = decompose({A, eliminated, centred}, options_.solver);
    solve().seconds.decomposition = stopwatch.seconds();
    if (attempt.solver == nullptr) return fail(attempt.failure);
    solve().unknowns = attempt.solver->unknowns();
    solve().factorNonzeros = attempt.solver->factorNonzeros();
    solve().method = attempt.solver->method();

    progress_.stage("solving");
    const Stopwatch solution;
    const Columns3 f = turnedDetail(result_.operators, result_.rotations, model_.solverMesh.diagonal);
    const Displacement displacement =
        attempt.solver->solve({shiftsOf(result_.system), result_.diagnosis.reconciled}, f);
    accept(displacement);
    solve().seconds.solution = solution.seconds();
    if (options_.solver.kind == SolverKind::Hard && solve().status != SolveStatus::Failed)
      weigh(forcesOf(A, eliminated, displacement.u, f, model_.solverMesh.diagonal));
  }

  void diagnoseRows(const EliminatedConstraints& eliminated)
  {
    result_.diagnosis = diagnose(eliminated, result_.system, model_.solverMesh);
    result_.report.constraints = outcomes(constraints_, result_.system, result_.diagnosis);
    setAmplifications(result_.report.constraints, result_.system, result_.diagnosis,
                      eliminated.elimination.amplifications());
  }

  /// Finds the rotations and what they make of the rows; false when that fails.
  bool rotate()
  {
    progress_.stage("solving the rotation field");
    Rotations rotations =
        RotationStage(model_.solverMesh, options_.weights, options_.solver.backend).solve(result_.system);
    if (!rotations.failure.empty()) {
      fail("the rotation field cannot be solved: " + rotations.failure);
      return false;
    }
    result_.system = turned(std::move(result_.system), rotations.q);
    result_.rotations = std::move(rotations.q);
    return true;
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
    solve().refinementSteps = displacement.corrections;
    solve().accuracy = displacement.accuracy;
    if (!displacement.u.allFinite()) return fail("the solution is not finite: the problem is singular in doubles");
    if (displacement.accuracy > kUsableAccuracy)
      return fail(fmt::format("the solution is accurate to {:.1g} only: the problem is nearly singular",
                              displacement.accuracy));
    // Pins of a soft solution are not met, so none is copied.
    const bool isExact = options_.solver.kind != SolverKind::Soft;
    result_.positions = isExact ? deformedPositions(model_, result_.system, result_.diagnosis, displacement.u)
                                : deformedPositions(model_, {}, {}, displacement.u);
    judge();
  }

  void judge()
  {
    const double limit = residualLimit(model_.solverMesh, result_.system);
    setResiduals(result_.report, result_.system, result_.diagnosis,
                 rowResiduals(result_.system, model_.solverMesh.weld, result_.positions), limit);
    solve().status = result_.diagnosis.hasConflicts() ? SolveStatus::Conflicts : SolveStatus::Ok;
    solve().message = solvedMessage(result_, limit);
    if (options_.solver.kind == SolverKind::Hard && solve().maxResidual > limit)
      fail(missedMessage(result_.report, limit));
  }

  const Model& model_;
  const ConstraintList& constraints_;
  const std::string& source_;
  const DeformOptions& options_;
  Progress& progress_;
  Deformation result_;
};

}  // namespace

Deformation deform(const Model& model, const ConstraintList& constraints, const std::string& source,
                   const DeformOptions& options, Progress& progress)
{
  return Run(model, constraints, source, options, progress).run();
}

Report diagnoseConstraints(const Model& model, const ConstraintList& constraints, const std::string& source)
{
  Report report;
  report.mesh = describeMesh(model);
  ConstraintSystem system =
      makeConstraintSystem(constraints, model.mesh, model.triangulation, model.solverMesh, source);
  const EliminatedConstraints eliminated = eliminate(system, model.solverMesh);
  const Rotations rotations = RotationStage(model.solverMesh, Weights::Cotangent, defaultBackend()).solve(system);
  if (rotations.failure.empty()) system = turned(std::move(system), rotations.q);
  const Diagnosis diagnosis = diagnose(eliminated, system, model.solverMesh);
  report.constraints = outcomes(constraints, system, diagnosis);
  setAmplifications(report.constraints, system, diagnosis, eliminated.elimination.amplifications());
  for (Finding& finding : constraintFindings(model, eliminated)) report.mesh.findings.push_back(std::move(finding));
  addConstraintFindings(report);
  addNotes(report, constraints, system);
  return report;
}

MeshReport describeMesh(const Model& model)
{
  return {model.mesh.vertexCount(), model.mesh.faces.size(), model.solverMesh.componentCount, model.solverMesh.diagonal,
          model.findings};
}

}  // namespace holdfast
