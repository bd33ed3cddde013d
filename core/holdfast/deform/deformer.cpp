#include "holdfast/deform/deformer.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/base/largest_size.h>
#include <holdfast/base/parallel.h>
#include <holdfast/base/thread_priority.h>
#include <holdfast/check/mesh_check.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/determined_part.h>
#include <holdfast/deform/forces.h>
#include <holdfast/deform/found_shape.h>
#include <holdfast/deform/messages.h>
#include <holdfast/deform/place_findings.h>
#include <holdfast/deform/rotation_factorization.h>
#include <holdfast/operators/model_size.h>
#include <holdfast/ordering/elimination_order.h>
#include <holdfast/rotation/decided_rotations.h>
#include <holdfast/solve/constrained_solver.h>
#include <holdfast/solve/moved_solutions.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/verdict/result_check.h>

namespace holdfast {
namespace {

// Where rows that nearly depend on others keep a solution from meeting all of them, those closer than this many times
// the distance before are left out, and so on up to the largest one: it keeps amplification below some thousands.
constexpr double kDistanceStep = 100;
constexpr double kLargestNeededDistance = 1e-3;

// Of fewer points that nearly follow from one another a person can choose: that they cannot be held is an error.
constexpr std::ptrdiff_t kManyPoints = 32;

double largestOf(const std::vector<double>& values)
{
  return values.empty() ? 1 : *std::ranges::max_element(values);
}

/// Whether there are many points off the vertices.
bool hasManyPoints(const std::vector<ConstraintRow>& rows)
{
  return std::ranges::count_if(rows, [](const ConstraintRow& row) { return row.terms.size() > 1; }) > kManyPoints;
}

/// The solver's options for rows of A that were made for lengths in diagonals, as those of given rotations are.
SolverOptions inDiagonals(const DeformOptions& options, const SolverMesh& mesh)
{
  SolverOptions result = options.solver;
  const bool isScaled = result.kind == SolverKind::Soft && result.softWeight > 0;  // others are refused as they are
  if (isScaled && options.rotations.source == RotationSource::Given)
    result.softWeight /= rowsInDiameters(options.weights, diameterInDiagonals(mesh));
  return result;
}

}  // namespace

/// All that the structure of a set of constraints costs, for any targets: the second of the three calls of section 6.
/// The elimination and, once they are asked for, the factors of positions and rotations.
struct ConstraintFactorization {
  ConstraintFactorization(std::shared_ptr<const Model> model, std::shared_ptr<const Operators> operators,
                          const std::shared_ptr<const EnergyMatrix>& A, const std::vector<int>& ranks,
                          const ConstraintSystem& itsSystem, const DeformOptions& options, double itsTolerance)
      : system(itsSystem),
        tolerance(itsTolerance),
        eliminated(std::make_shared<const EliminatedConstraints>(eliminate(system, model->solverMesh, tolerance))),
        sensitivities(std::make_shared<const std::vector<double>>(eliminated->elimination.sensitivities())),
        mayHaveFewerRows(hasManyPoints(system.rows) && !(largestOf(*sensitivities) < 1 / kLargestNeededDistance)),
        actedOn(
            std::async(std::launch::deferred, [A, eliminated = eliminated] { return ActedOn(*A, eliminated->rows); })),
        rotations(std::make_shared<RotationFactorization>(model->solverMesh, std::move(operators),
                                                          options.solver.backend, ranks)),
        positions([model = std::move(model), A, eliminated = eliminated, ranks, options = options]() mutable {
          const Columns3& rest = model->solverMesh.rest;
          return makeSolver({A, eliminated, rest.rowwise() - rest.colwise().mean(), std::move(ranks)},
                            inDiagonals(options, model->solverMesh));
        })
  {
  }

  /// The same under the constraints of `wanted`, by the factor of `base`.
  ConstraintFactorization(const ConstraintFactorization& wanted, std::shared_ptr<ConstraintFactorization> base)
      : system(wanted.system),
        tolerance(wanted.tolerance),
        eliminated(wanted.eliminated),
        sensitivities(wanted.sensitivities),
        mayHaveFewerRows(wanted.mayHaveFewerRows),
        actedOn(wanted.actedOn),
        rotations(wanted.rotations),
        positions([base = std::move(base), eliminated = eliminated] {
          return base->positions.result(noProgress()).value->edited(eliminated);
        }),
        isBordered(true)
  {
  }

  /// Whether `other` has the rows, given rotations and rigid regions that this was made of. O(terms).
  [[nodiscard]] bool serves(const ConstraintSystem& other) const
  {
    std::atomic<bool> isSame = other.rows.size() == system.rows.size();
    if (isSame)
      parallelBlocks(static_cast<Index>(system.rows.size()), [&](Index r) {
        if (other.rows[r].terms != system.rows[r].terms) isSame = false;
      });
    return isSame && turnsAs(other);
  }

  /// Whether `other` has the same given rotations and rigid regions.
  [[nodiscard]] bool turnsAs(const ConstraintSystem& other) const
  {
    return std::ranges::equal(other.rotations, system.rotations, {}, &GivenRotation::unknown,
                              &GivenRotation::unknown) &&
           other.rigidRegions == system.rigidRegions;
  }

  /// Whether the same rows stand in both.
  [[nodiscard]] bool standsOn(const ConstraintFactorization& other) const
  {
    return std::ranges::equal(eliminated->dependencies, other.eliminated->dependencies, {}, &Dependency::row,
                              &Dependency::row);
  }

  /// Whether it has a factor, and it can be used.
  [[nodiscard]] bool isReady() { return positions.isDone() && positions.result(noProgress()); }

  ConstraintSystem system;
  double tolerance;  // rows closer to those before them are left out
  std::shared_ptr<const EliminatedConstraints> eliminated;
  std::shared_ptr<const std::vector<double>> sensitivities;
  bool mayHaveFewerRows;  // where they cannot be met, by a larger tolerance
  KnownGaps knownGaps;
  std::shared_future<ActedOn> actedOn;  // made with the first forces
  std::shared_ptr<RotationFactorization> rotations;
  LongStep<SolverResult> positions;
  std::unique_ptr<MovedSolutions> moved;  // where solutions may be sums of earlier ones
  bool isBordered = false;
  bool isForOneCall = false;  // the factor of rotations is released before that of positions takes memory
};

namespace {

// A border by which fewer digits are left is not used.
constexpr double kBorderedAccuracy = 1e-8;

// Vertices that move by fewer diagonals leave doubles with the digits that the promised residual takes.
constexpr double kFarMove = 100;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// For each unknown, whether it is several vertices of the file.
std::vector<char> sharedUnknowns(const Weld& weld)
{
  std::vector<char> isShared(static_cast<std::size_t>(weld.unknownCount), 0);
  if (weld.unknownCount == static_cast<Index>(weld.unknownOf.size())) return isShared;
  for (std::size_t v = 0; v < weld.unknownOf.size(); ++v)
    if (weld.firstVertexOf[weld.unknownOf[v]] != static_cast<int>(v)) isShared[weld.unknownOf[v]] = 1;
  return isShared;
}

/// `target`; but at rest the coordinates of the file, of which vertices that are one unknown may have 0 and -0.
Eigen::RowVector3d pinned(const Vector3& target, const Eigen::RowVector3d& rest, bool isShared)
{
  Eigen::RowVector3d place = target;
  for (Index k = 0; k < 3; ++k)
    if (isShared && place[k] == rest[k]) place[k] = rest[k];
  return place;
}

/// The file's positions: pins as they were asked for, bit for bit, everything else displaced from rest.
Positions deformedPositions(const Model& model, const ConstraintSystem& system, const Diagnosis& diagnosis,
                            const Columns3& u)
{
  const std::vector<int>& unknownOf = model.solverMesh.weld.unknownOf;
  std::vector<int> pinOf(static_cast<std::size_t>(model.solverMesh.unknownCount()), -1);
  for (Index r = static_cast<Index>(system.rows.size()) - 1; r >= 0; --r)
    if (system.rows[r].isPin() && diagnosis.status[r] != RowStatus::Conflicting)
      pinOf[system.rows[r].terms.front().index] = static_cast<int>(r);
  const std::vector<char> isShared = sharedUnknowns(model.solverMesh.weld);
  const Positions& rest = model.mesh.positions;
  const bool isApart = model.solverMesh.weld.joinsApart;
  Positions positions(rest.rows(), 3);
  parallelBlocks(rest.rows(), [&](Index v) {
    const Index unknown = unknownOf[v];
    const bool isPin = pinOf[unknown] >= 0;
    const bool rests = isPin && isApart && system.rows[pinOf[unknown]].shift.isZero(0);
    if (rests)
      positions.row(v) = rest.row(v);  // vertices that are one unknown within a tolerance keep places of their own
    else if (isPin)
      positions.row(v) = pinned(system.rows[pinOf[unknown]].target, rest.row(v), isShared[unknown] != 0);
    else if (u.row(unknown).isZero(0))
      positions.row(v) = rest.row(v);  // -0 stays -0
    else
      positions.row(v) = rest.row(v) + u.row(unknown);
  });
  return positions;
}

/// How rotations are found.
struct RotationSearch {
  const RotationEnergy* energy;  ///< none where they are given
  RotationOptions options;
  const Columns3* before;  ///< those of the last call, from which this one goes on; none where it starts anew
};

/// One solution, and what is to be said of it.
class Solution {
 public:
  Solution(const Model& model, std::shared_ptr<const ConstraintLabels> labels, const DeformOptions& options,
           std::shared_ptr<const Operators> operators, std::shared_ptr<const EnergyMatrix> A,
           const RotationSearch& search, ConstraintSystem system)
      : model_(model), options_(options), A_(std::move(A)), search_(search)
  {
    details_->labels = std::move(labels);
    details_->operators = std::move(operators);
    details_->system = std::move(system);
    result_.details = details_;
    result_.report.mesh = describeMesh(model);
    report().weights = options.weights;
    report().options = options.solver;
    report().rotations = options.rotations.source;
  }

  /// Everything but the seconds that went before.
  DeformResult by(ConstraintFactorization& factorization, Progress& progress)
  {
    std::string refusal;
    if (details_->operators->undefinedRows.empty()) {
      if (!factorization.isForOneCall) {
        announceFactorization(factorization, progress);
        factorization.positions.start(progress);  // beside the rotations
      }
      refusal = rotate(factorization, progress);
    } else {
      refusal = undefinedRowsMessage(model_, *details_->operators);
    }
    details_->sensitivities = factorization.sensitivities;
    diagnoseRows(factorization);
    if (!refusal.empty()) {
      result_.rotations = Columns3::Zero(model_.solverMesh.unknownCount(), 3);
      refuse(refusal);
    }
    addFindings(factorization);
    if (report().status != SolveStatus::Failed) solve(factorization, progress);
    if (std::optional<Finding> crowd = crowdedFinding(*details_))
      result_.report.mesh.findings.push_back(*std::move(crowd));
    details_->diagnosis.particular = {};
    return std::move(result_);
  }

 private:
  [[nodiscard]] SolveReport& report() { return result_.report.solve; }

  /// Numbers went wrong, and other options may help.
  void fail(const std::string& reason) { refuse(failureMessage(options_, reason)); }

  /// The same where it may be that rows nearly depend on others: what distance would keep `u` near.
  void failNearby(const Columns3& u, const std::string& reason)
  {
    if (options_.solver.kind == SolverKind::Hard) details_->neededDistance = neededDistance(largestSize(u));
    fail(reason);
  }

  /// An inconsistency moves vertices by its size times the largest sensitivity: this many diagonals now.
  [[nodiscard]] double neededDistance(double largestMove) const
  {
    const double moved = largestMove / model_.solverMesh.diagonal;
    const double spread = largestOf(*details_->sensitivities);
    const double distance = moved / (kFarMove * spread);
    return std::isfinite(distance) ? std::max(distance, kRankTolerance) : kRankTolerance;
  }

  void refuse(const std::string& message)
  {
    report().status = SolveStatus::Failed;
    report().message = message;
    result_.positions = model_.mesh.positions;
    // Residuals of positions that are discarded would mislead.
    details_->residuals.clear();
    details_->multipliers = {};
    tellOutcomes();
  }

  void diagnoseRows(ConstraintFactorization& factorization)
  {
    details_->diagnosis =
        diagnose(*factorization.eliminated, details_->system, model_.solverMesh, factorization.knownGaps);
    if (search_.energy == nullptr && result_.rotations.rows() > 0)
      details_->diagnosis.metIfFound = closedWhereFound(*factorization.eliminated, details_->system, model_.solverMesh,
                                                        details_->diagnosis, result_.rotations);
  }

  /// They are made of the details as these are when somebody first looks.
  void tellOutcomes()
  {
    result_.report.constraints =
        ConstraintOutcomes([details = result_.details] { return outcomes(*details, details->residuals); });
  }

  /// Finds the rotations and what they make of the rows; the message where they cannot be found.
  std::string rotate(ConstraintFactorization& factorization, Progress& progress)
  {
    const bool isFactorised = factorization.rotations->isReady();
    const auto start = Clock::now();
    if (!isFactorised) progress.step("solving the rotation field");
    Rotations rotations = factorization.rotations->solve(details_->system, progress);
    Seconds& seconds = report().seconds;
    (isFactorised ? seconds.solution : seconds.factorization) += secondsSince(start);
    if (factorization.isForOneCall) factorization.rotations.reset();
    takeOver(rotations, result_.report);
    if (!rotations.failure.empty()) return failureMessage(options_, rotations.failure);
    details_->system = rotated(std::move(details_->system), rotations.q);
    result_.rotations = std::move(rotations.q);
    return {};
  }

  static void announceFactorization(const ConstraintFactorization& factorization, Progress& progress)
  {
    if (!factorization.positions.isDone())
      progress.step(fmt::format("factorising {} unknowns", factorization.eliminated->elimination.freeCount()));
  }

  void addFindings(const ConstraintFactorization& factorization)
  {
    std::vector<Finding>& findings = result_.report.mesh.findings;
    for (Finding& finding : guardFindings(*details_->operators, model_.solverMesh))
      findings.push_back(std::move(finding));
    for (Finding& finding : constraintFindings(model_, *factorization.eliminated, *details_))
      findings.push_back(std::move(finding));
  }

  void solve(ConstraintFactorization& factorization, Progress& progress)
  {
    const auto start = Clock::now();
    announceFactorization(factorization, progress);
    const SolverResult& result = factorization.positions.result(progress);
    report().seconds.factorization += secondsSince(start);
    if (!result) return fail(result.failure);
    progress.step("solving");
    const auto solution = Clock::now();
    SolvedDisplacement solved;
    if (search_.energy != nullptr)
      solved = find(*result.value, factorization, progress);
    else if (factorization.moved == nullptr)
      solved = solve(*result.value);
    else
      solved = factorization.moved->solve(*result.value, targets(), result_.rotations, [this] { return makeF(); });
    report().unknowns = result.value->unknowns();
    report().factorNonzeros = result.value->factorNonzeros();
    report().method = result.value->method();
    if (options_.solver.kind == SolverKind::Hard) details_->multipliers = multipliersOf(solved, factorization);
    if (factorization.isBordered && solved.displacement->accuracy > kBorderedAccuracy)
      return fail("the border leaves too few digits");
    accept(*result.value, *solved.displacement);
    report().seconds.solution += secondsSince(solution);
  }

  [[nodiscard]] RowTargets targets()
  {
    Diagnosis& diagnosis = details_->diagnosis;
    return {shiftsOf(details_->system), diagnosis.reconciled, std::move(diagnosis.particular)};
  }

  [[nodiscard]] Columns3 makeF() const
  {
    const Eigen::VectorXd& weights = details_->operators->rowWeights;
    Columns3 f = rotationOfDelta(details_->operators->delta, result_.rotations);
    parallelBlocks(f.rows(), [&](Index i) { f.row(i) *= model_.solverMesh.diagonal * weights[i]; });
    return f;
  }

  [[nodiscard]] SolvedDisplacement solve(const ConstrainedSolver& solver)
  {
    auto f = std::make_shared<const Columns3>(makeF());
    auto displacement = std::make_shared<const Displacement>(solver.solve(targets(), *f));
    return {std::move(displacement), std::move(f)};
  }

  SolvedDisplacement find(const ConstrainedSolver& solver, ConstraintFactorization& factorization, Progress& progress)
  {
    const FoundProblem problem{*search_.energy, model_.solverMesh, *factorization.eliminated, solver};
    FoundShape shape =
        findShape(problem, std::move(details_->system),
                  {std::move(result_.rotations), search_.before == nullptr ? Columns3() : *search_.before},
                  search_.options, progress);
    report().iterations = shape.iterations;
    if (!shape.iterations.isConverged && search_.before == nullptr)
      result_.report.mesh.findings.push_back(unconvergedWarning(shape.iterations, search_.options));
    result_.rotations = std::move(shape.q);
    details_->system = std::move(shape.system);
    diagnoseRows(factorization);
    details_->diagnosis.reasons = std::move(shape.reasons);
    std::vector<Finding>& findings = result_.report.mesh.findings;
    findings.insert(findings.end(), shape.findings.begin(), shape.findings.end());
    return {std::make_shared<const Displacement>(std::move(shape.displacement)),
            std::make_shared<const Columns3>(std::move(shape.wanted))};
  }

  /// They are made whenever somebody asks for them: nothing that they are made of changes.
  [[nodiscard]] std::shared_future<Multipliers> multipliersOf(SolvedDisplacement solved,
                                                              const ConstraintFactorization& factorization) const
  {
    return std::async(std::launch::deferred,
                      [A = A_, actedOn = factorization.actedOn, eliminated = factorization.eliminated,
                       diagonal = model_.solverMesh.diagonal, solved]() mutable {
                        const SolvedDisplacement its = std::exchange(solved, {});  // not to be kept beside the forces
                        Columns3 forces = forcesAtUnknowns(*A, actedOn.get(), its.displacement->u, *its.f, diagonal);
                        return Multipliers{eliminated->elimination.multipliers(forces), std::move(forces)};
                      });
  }

  /// Takes the solution over when it is one.
  void accept(const ConstrainedSolver& solver, const Displacement& displacement)
  {
    report().refinementSteps = displacement.corrections;
    if (!std::isfinite(largestSize(displacement.u)))
      return failNearby(displacement.u, "the solution is not finite: the problem is singular in doubles");
    if (const std::string failure = judgeAccuracy(solver, displacement); !failure.empty())
      return failNearby(displacement.u, "the solution cannot be used: " + failure);
    // The elimination copies pins. What the other solvers find is measured as they find it.
    const bool isEliminated = options_.solver.kind == SolverKind::Hard;
    result_.positions = isEliminated ? deformedPositions(model_, details_->system, details_->diagnosis, displacement.u)
                                     : deformedPositions(model_, {}, {}, displacement.u);
    setVerdicts(displacement.u);
  }

  /// Sets the accuracy of both parts, what constraints determine and what they leave free, and warns of the worse one.
  /// Returns why it is refused; nothing where it is not. Other solvers than `Hard` do not tell the parts apart.
  std::string judgeAccuracy(const ConstrainedSolver& solver, const Displacement& displacement)
  {
    const DeterminedPart determined = options_.solver.kind == SolverKind::Hard
                                          ? determinedPart(details_->system, *details_->sensitivities, solver,
                                                           details_->diagnosis.reconciled, displacement.u)
                                          : DeterminedPart{};
    report().accuracy = std::max(displacement.accuracy, determined.accuracy);
    const bool isOfRows = determined.accuracy > displacement.accuracy;
    const std::optional<Finding> warning = isOfRows
                                               ? determinedWarning(*details_, determined)
                                               : accuracyWarning("low_accuracy", "the solution", displacement.accuracy);
    if (warning) result_.report.mesh.findings.push_back(*warning);
    return isOfRows ? determinedFailure(*details_, determined) : accuracyFailure(displacement.accuracy);
  }

  void setVerdicts(const Columns3& u)
  {
    const SolverMesh& mesh = model_.solverMesh;
    Diagnosis& diagnosis = details_->diagnosis;
    if (!diagnosis.isNearOrigin) diagnosis.limits = residualLimits(mesh, details_->system, diagnosis.dependent, u);
    details_->residuals = rowResiduals(details_->system, mesh.weld, result_.positions);
    if (options_.solver.kind == SolverKind::Hard) judgeUndecided();
    tellOutcomes();
    const std::optional<MissedRow> worst = setLargestResidual(result_.report, *details_, details_->residuals);
    report().status = diagnosis.hasConflicts() ? SolveStatus::Conflicts : SolveStatus::Ok;
    report().message = solvedMessage(result_.report, worst);
    if (options_.solver.kind == SolverKind::Hard && worst) failNearby(u, missedMessage(result_.report, *worst));
  }

  /// Rows too close to depending on others to be held with them hold where the solution happens to meet them.
  void judgeUndecided()
  {
    Diagnosis& diagnosis = details_->diagnosis;
    for (const auto& [dependency, gap] : diagnosis.dependent)
      if (dependency.isUndecided())
        diagnosis.status[dependency.row] = details_->residuals[dependency.row] <= diagnosis.limits[dependency.row]
                                               ? RowStatus::Redundant
                                               : RowStatus::Conflicting;
  }

  const Model& model_;
  const DeformOptions& options_;
  std::shared_ptr<const EnergyMatrix> A_;
  const RotationSearch& search_;
  std::shared_ptr<DeformDetails> details_ = std::make_shared<DeformDetails>();
  DeformResult result_;
};

}  // namespace

Deformer::Deformer(Model model, const DeformOptions& options)
    : Deformer(std::make_shared<const Model>(std::move(model)), options)
{
}

Deformer::Deformer(std::shared_ptr<const Model> model, const DeformOptions& options)
    : model_(std::move(model)),
      options_(options),
      places_(std::make_unique<KnownPlaces>()),
      placeFindings_(std::make_unique<PlaceFindings>())
{
}

Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;
Deformer::~Deformer() = default;

Constraint& Deformer::constraint(std::string_view name)
{
  const auto found = std::ranges::find(constraints_.constraints, name, &Constraint::name);
  if (found == constraints_.constraints.end())
    throw InputError({"constraints", 0, {}}, fmt::format("there is none called \"{}\"", name));
  return *found;
}

void Deformer::setTarget(std::string_view name, const Vector3& place)
{
  auto* point = std::get_if<PointConstraint>(&constraint(name).what);
  if (point == nullptr)
    throw InputError({"constraints", 0, std::string(name)},
                     "it is no point, so it has no target; give the name of a point");
  point->to = Target{place};
}

ConstraintSystem Deformer::systemOf(const ConstraintList& constraints, const std::string& source)
{
  const SurfaceLocator locator =
      isForOneCall_ ? SurfaceLocator(model_->mesh, model_->triangulation) : model_->locator();
  ConstraintSystem system =
      makeConstraintSystem(constraints, model_->mesh, model_->solverMesh, locator, source, *places_);
  placeFindings_->update(system.nearPlaces, locator, options_.nearLimit * model_->solverMesh.diagonal);
  return system;
}

std::shared_ptr<ConstraintFactorization> Deformer::factorizationBy(const ConstraintSystem& system, double tolerance,
                                                                   Progress& progress)
{
  auto result = std::make_shared<ConstraintFactorization>(model_, operators_, A_, ranks_->result(progress), system,
                                                          options_, tolerance);
  if (factorization_ != nullptr && factorization_->rotations != nullptr && factorization_->turnsAs(system))
    result->rotations = factorization_->rotations;
  return result;
}

ConstraintFactorization* Deformer::withFewerRows(const ConstraintSystem& system, double neededDistance,
                                                 Progress& progress)
{
  if (neededDistance == 0 || !factorization_->mayHaveFewerRows) return nullptr;
  progress.step("leaving out constraints that nearly follow from others");
  double tolerance = factorization_->tolerance;
  while (tolerance < kLargestNeededDistance) {
    tolerance = std::min(kLargestNeededDistance, std::max(kDistanceStep * tolerance, neededDistance));
    std::shared_ptr<ConstraintFactorization> fewer = factorizationBy(system, tolerance, progress);
    if (fewer->standsOn(*factorization_)) continue;
    coming_ = nullptr;
    whole_ = nullptr;
    fewer->isForOneCall = factorization_->isForOneCall;
    factorization_ = std::move(fewer);
    return factorization_.get();
  }
  return nullptr;
}

ConstraintFactorization& Deformer::factorizationFor(const ConstraintSystem& system, Progress& progress)
{
  const auto made = [&] { return factorizationBy(system, kRankTolerance, progress); };
  if (coming_ != nullptr && coming_->serves(system) && coming_->isReady()) factorization_ = std::exchange(coming_, {});
  if (factorization_ != nullptr && factorization_->serves(system)) {
    if (factorization_->isBordered && coming_ == nullptr) coming_ = made();  // it was given up for a cancelled edit
    return *factorization_;
  }

  if (whole_ != nullptr && whole_->serves(system)) {  // back to where edits began
    coming_ = nullptr;
    factorization_ = whole_;
    return *factorization_;
  }
  if (answersEditsAtOnce_ && factorization_ != nullptr && !factorization_->isBordered && factorization_->isReady())
    whole_ = factorization_;
  progress.step(fmt::format("eliminating {} rows of constraints", system.rows.size()));
  coming_ = nullptr;  // of other rows: it would take cores from what is wanted now
  std::shared_ptr<ConstraintFactorization> wanted = made();
  if (answersEditsAtOnce_ && whole_ != nullptr && whole_->turnsAs(system)) {
    auto bordered = std::make_shared<ConstraintFactorization>(*wanted, whole_);
    if (bordered->positions.result(progress)) {
      coming_ = std::move(wanted);
      factorization_ = std::move(bordered);
      return *factorization_;
    }
  }
  whole_ = nullptr;
  factorization_ = std::move(wanted);
  return *factorization_;
}

DeformResult Deformer::deform(const ConstraintList& constraints, const std::string& source, Progress& progress)
{
  Seconds seconds;
  const auto setup = Clock::now();
  if (ranks_ == nullptr)
    ranks_ = std::make_unique<LongStep<std::vector<int>>>([isOurs = options_.solver.backend == Backend::Holdfast,
                                                           n = model_->solverMesh.unknownCount(),
                                                           triangles = model_->solverMesh.triangles]() mutable {
      const std::vector<Triangle> own = std::move(triangles);  // not to be kept beside the order
      return isOurs ? eliminationRanks(n, own) : std::vector<int>();
    });
  if (!ranks_->isDone()) progress.step(fmt::format("ordering {} unknowns", model_->solverMesh.unknownCount()));
  ranks_->start(progress);
  ConstraintSystem system = systemOf(constraints, source);
  labels_ = labelsOf(constraints, std::move(labels_));
  const bool isFound = options_.rotations.source != RotationSource::Given;
  if (isFound) system = withStatedRotations(std::move(system));
  if (operators_ == nullptr) {
    progress.step(fmt::format("building operators of {} vertices", model_->mesh.vertexCount()));
    operators_ = std::make_shared<const Operators>(makeOperators(model_->solverMesh, options_.weights));
    if (isFound)
      energy_ = std::make_shared<const RotationEnergy>(model_->solverMesh, *operators_, options_.rotations.source);
    A_ = isFound ? energy_->A() : std::make_shared<const EnergyMatrix>(weightedRows(*operators_));
  }
  seconds.setup = secondsSince(setup);

  const auto elimination = Clock::now();
  ConstraintFactorization& factorization = factorizationFor(system, progress);
  seconds.factorization = secondsSince(elimination);
  factorization.isForOneCall = isForOneCall_;

  RotationSearch search{energy_.get(), options_.rotations, nullptr};
  if (continued_ > 0) {
    search.before = &lastRotations_;
    search.options.mostIterations = continued_;
  }
  const auto solved = [&](ConstraintFactorization& by, ConstraintSystem its) {
    if (answersEditsAtOnce_ && by.moved == nullptr)
      by.moved = by.isBordered && whole_->moved != nullptr
                     ? std::make_unique<MovedSolutions>(model_->solverMesh, *whole_->moved)
                     : std::make_unique<MovedSolutions>(model_->solverMesh);
    return Solution(*model_, labels_, options_, operators_, A_, search, std::move(its)).by(by, progress);
  };
  ConstraintSystem again;
  if (factorization.isBordered || factorization.mayHaveFewerRows) again = system;
  DeformResult result = solved(factorization, std::move(system));
  if (factorization.isBordered && result.report.solve.status == SolveStatus::Failed) {
    factorization_ = std::exchange(coming_, {});
    result = solved(*factorization_, again);
  }
  while (ConstraintFactorization* fewer = withFewerRows(again, result.details->neededDistance, progress))
    result = solved(*fewer, again);
  if (coming_ != nullptr) coming_->positions.start(progress, computeInBackground);
  if (isFound && result.report.solve.status != SolveStatus::Failed) lastRotations_ = result.rotations;
  placeFindings_->addTo(result.report.mesh.findings);
  result.report.solve.seconds.setup = seconds.setup;
  result.report.solve.seconds.factorization += seconds.factorization;
  return result;
}

Report Deformer::checked(const DeformResult& result)
{
  Report report = result.report;
  if (report.solve.status == SolveStatus::Failed) return report;
  if (check_ == nullptr) check_ = std::make_unique<ResultCheck>(model_->solverMesh, model_->mesh.positions);
  CheckedResult checked = check_->ofFrame(result.positions, result.details->system);
  report.result = std::move(checked.verdict);
  std::ranges::move(checked.findings, std::back_inserter(report.mesh.findings));
  return report;
}

Report Deformer::examined(const DeformResult& result, Progress& progress)
{
  progress.step("looking at the result");
  Report report = checked(result);
  if (report.solve.status == SolveStatus::Failed) return report;
  std::ranges::move(
      check_->addRest(report.result, result.positions, result.details->system, report.solve.rotations, progress),
      std::back_inserter(report.mesh.findings));
  return report;
}

}  // namespace holdfast
