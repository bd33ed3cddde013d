#pragma once
/// A report is what a deformation tells about itself. docs/formats.md describes the report file, and `report_json.h`
/// writes it.

#include <functional>
#include <future>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/constraints/skipped_row.h>
#include <holdfast/operators/weights.h>
#include <holdfast/rotation/rotation_options.h>
#include <holdfast/solve/solver_options.h>
#include <holdfast/verdict/result_verdict.h>

namespace holdfast {

/// What the report says of the mesh.
struct MeshReport {
  Index vertices = 0;
  Index faces = 0;
  Index components = 0;     ///< connected parts; vertices that no face uses are in none
  double bboxDiagonal = 0;  ///< of the bounding box at rest, model units
  std::vector<Finding> findings;
};

/// How a constraint fared.
enum class ConstraintStatus {
  Independent,  ///< nothing was solved; it neither follows from constraints before it nor contradicts them
  Met,          ///< its residual is within its limit
  Redundant,    ///< it follows from constraints before it, and agrees with them
  Conflicting,  ///< it contradicts constraints before it; its rows that do so were left out
  Missed,       ///< its residual is beyond its limit: soft constraints, Lagrange multipliers, binary STL
  Disabled
};

/// Returns the name of a status in reports: "independent", "met", "redundant", ...
[[nodiscard]] std::string_view name(ConstraintStatus status);

/// A report lists no more names than this of the constraints that one follows from. The first `kMostWithManyPartners`
/// constraints that follow from others list `kMostNamedPartners` names each. All behind them list `kFewPartners`. In a
/// patch with more points than vertices thousands of constraints follow from dozens of others each.
inline constexpr std::size_t kMostNamedPartners = 100;
inline constexpr std::size_t kFewPartners = 16;
inline constexpr std::size_t kMostWithManyPartners = 100;

/// One way in which a constraint follows from others. None of the others can be left out.
struct ConflictSet {
  /// The names of constraints before it, in their order, as many as are listed. There are none where the constraint
  /// contradicts or repeats itself, or where its part stays at rest.
  std::vector<std::string> with;
  Index rows = 0;                 ///< how many rows of the constraint depend on just these
  Vector3 gap = Vector3::Zero();  ///< what it asks for less what they imply, model units; the largest of these rows
  bool isConflict = false;        ///< whether the gap exceeds the promise; else the constraint only repeats the others
  /// The first repair of a conflict: the constraint to disable. It is the one that takes part in most conflicts. Of
  /// several it is the one with the fewest rows, and of these the latest.
  std::string disable;
  /// The second repair, for a point or an offset: the target that agrees with all of `with`.
  std::optional<Vector3> consistentTarget;
  bool isMetByFoundRotations = false;  ///< whether rotations that are found would meet what given ones do not
  Index withCount = 0;                 ///< how many constraints there are in the set beside it, listed or not
};

/// What the report says of one constraint.
struct ConstraintOutcome {
  std::string name;
  std::string type;
  Index rows = 0;  ///< how many rows of B it makes; 0 when disabled
  ConstraintStatus status = ConstraintStatus::Disabled;
  std::optional<double> residual;  ///< the largest of its rows, model units; none when disabled or not solved
  /// The residual up to which the constraint is met, in model units (see `residualLimits`). It is the limit of a missed
  /// row where there is one, else the largest of its rows. There is none when it is disabled.
  std::optional<double> limit;
  /// The names of the constraints that a redundant or conflicting one follows from, as many as are listed.
  std::vector<std::string> dependsOn;
  std::optional<double> gap;  ///< how far it contradicts them, model units; none unless redundant or conflicting
  std::vector<ConflictSet> conflictSets;  ///< the smallest sets that it conflicts with or repeats
  /// How far vertices move, all together, for a unit of change in what one of its rows asks for. It is the largest of
  /// its rows, without units. There is none when it is disabled.
  std::optional<double> sensitivity;
  /// The largest distance from its `near` places to the surface at rest, in model units. There is none where it names
  /// no such place or is disabled.
  std::optional<double> nearDistance;
  /// How hard it pulls, without units (see docs/math.md). There is none unless hard constraints were solved.
  std::optional<double> multiplier;
  Index dependsOnCount = 0;  ///< how many constraints it follows from, listed or not
  /// How far a point with a tolerance or a weight is from its target, model units. None for others.
  std::optional<double> offTarget = {};
  /// A point with a tolerance is at a bound of it where it pulls; else it has room. None for others.
  std::optional<bool> isAtBound = {};
};

/// The outcomes of all constraints, in the order of the list. They are made when somebody first looks at one of them,
/// once for all copies. Any thread may do so.
class ConstraintOutcomes {
 public:
  ConstraintOutcomes(std::vector<ConstraintOutcome> outcomes = {});
  /// The outcomes are what `make` returns when it is called, once at most.
  explicit ConstraintOutcomes(std::function<std::vector<ConstraintOutcome>()> make);

  [[nodiscard]] const std::vector<ConstraintOutcome>& all() const { return outcomes_.get(); }
  [[nodiscard]] std::size_t size() const { return all().size(); }
  [[nodiscard]] bool empty() const { return all().empty(); }
  [[nodiscard]] const ConstraintOutcome& operator[](std::size_t place) const { return all()[place]; }
  [[nodiscard]] const ConstraintOutcome& back() const { return all().back(); }
  [[nodiscard]] auto begin() const { return all().begin(); }
  [[nodiscard]] auto end() const { return all().end(); }

 private:
  std::shared_future<std::vector<ConstraintOutcome>> outcomes_;
};

/// What became of the solution.
enum class SolveStatus {
  NotRun,     ///< nothing was solved
  Ok,         ///< there is a solution, and no constraints conflict
  Conflicts,  ///< there is a solution, from which the conflicting rows are left out
  Failed      ///< there is no usable solution; `message` says why
};

/// Returns the name of a status in reports: "not run", "ok", "conflicts", "failed".
[[nodiscard]] std::string_view name(SolveStatus status);

/// The seconds that the three steps took.
struct Seconds {
  double setup = 0;          ///< operators and rows of constraints
  double factorization = 0;  ///< elimination, rotation field and factorisation
  double solution = 0;       ///< one set of targets
};

/// How the iterations went that found rotations.
struct RotationIterations {
  int count = 0;
  double change = 0;  ///< how far the last one moved a vertex at most, as a share of `RotationEnergy::size`
  bool isConverged = false;
};

/// What the report says of the solution.
struct SolveReport {
  SolveStatus status = SolveStatus::NotRun;
  std::string message;             ///< one sentence for people, with the accuracy
  double maxResidual = 0;          ///< the largest of all rows that do not conflict, model units
  double maxResidualRelative = 0;  ///< the same as a share of the bounding box's diagonal
  Weights weights = Weights::Cotangent;
  SolverOptions options;
  std::string method;                         ///< the kind of the factor, in words
  Index unknowns = 0;                         ///< of the reduced system, for each of x, y and z
  Index factorNonzeros = 0;                   ///< how many non-zeros its factor has
  int refinementSteps = 0;                    ///< how many corrections followed the first solution
  double accuracy = 0;                        ///< the estimated relative error of the displacements
  std::optional<double> rotationAccuracy;     ///< the same of the rotation field; none where none was solved for
  std::optional<double> disagreementDegrees;  ///< the largest angle between rotations given in one rigid region
  RotationSource rotations = RotationSource::Given;
  std::optional<RotationIterations> iterations;  ///< none where rotations are given
  Seconds seconds;
};

/// A whole report.
///
///     for (const ConstraintOutcome& outcome : result.report.constraints)
///       if (outcome.status == ConstraintStatus::Conflicting)
///         for (const ConflictSet& set : outcome.conflictSets)
///           if (set.isConflict) std::cout << outcome.name << ": disable " << set.disable << '\n';
///     std::cout << result.report.solve.message << ", residual " << result.report.solve.maxResidual << '\n';
struct Report {
  MeshReport mesh;
  ConstraintOutcomes constraints;
  SolveReport solve;
  std::vector<SkippedRow> skippedRows = {};  ///< what the point list of the constraints lost; its reader sets this
  ResultVerdict result = {};                 ///< what the solution made of the part
};

}  // namespace holdfast
