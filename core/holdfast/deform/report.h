#pragma once
/// What a deformation tells about itself. docs/formats.md describes the report file, `report_json.h` writes it.

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

struct MeshReport {
  Index vertices = 0;
  Index faces = 0;
  Index components = 0;
  double bboxDiagonal = 0;  ///< model units
  std::vector<Finding> findings;
};

enum class ConstraintStatus {
  Independent,  ///< neither follows from constraints before it nor contradicts them; nothing was solved
  Met,          ///< residual within its limit
  Redundant,    ///< follows from constraints before it, and agrees with them
  Conflicting,  ///< contradicts constraints before it; what contradicts was left out
  Missed,       ///< soft constraints and Lagrange multipliers: residual beyond its limit
  Disabled
};

/// The name in reports: "independent", "met", "redundant", ...
[[nodiscard]] std::string_view name(ConstraintStatus status);

/// How many names are listed of the constraints that one follows from: `kMostNamedPartners` for the first
/// `kMostWithManyPartners` constraints that follow from others, `kFewPartners` for all behind them. In a patch with
/// more points than vertices thousands of constraints follow from dozens of others each.
inline constexpr std::size_t kMostNamedPartners = 100;
inline constexpr std::size_t kFewPartners = 16;
inline constexpr std::size_t kMostWithManyPartners = 100;

/// One way in which a constraint follows from others: none of them can be left out.
struct ConflictSet {
  /// Names of constraints before it, in their order, as many as are listed; none: its part stays at rest.
  std::vector<std::string> with;
  Index rows = 0;                 ///< how many of its rows depend on just these
  Vector3 gap = Vector3::Zero();  ///< what it asks for less what they imply, model units: the largest of those rows
  bool isConflict = false;        ///< beyond the promise; else it only repeats them
  /// Repairs of a conflict. The constraint to disable that ends most conflicts at the price of the fewest rows, the
  /// later one of equals; and, for a point or an offset, the target that agrees with all of `with`.
  std::string disable;
  std::optional<Vector3> consistentTarget;
  bool isMetByFoundRotations = false;  ///< a conflict of given rotations alone: "found" ones meet it
  Index withCount = 0;                 ///< how many constraints there are in `with`, listed or not
};

struct ConstraintOutcome {
  std::string name;
  std::string type;
  Index rows = 0;  ///< rows of B; 0 when disabled
  ConstraintStatus status = ConstraintStatus::Disabled;
  std::optional<double> residual;  ///< largest distance from target, model units; none when disabled or not solved
  /// The residual up to which it is met, see `residualLimits`: of a missed row where there is one, else the largest of
  /// its rows; none when disabled.
  std::optional<double> limit;
  /// Names of the constraints that a redundant or conflicting one follows from, as many as are listed.
  std::vector<std::string> dependsOn;
  std::optional<double> gap;  ///< how far it contradicts them, model units; of redundant and conflicting ones
  std::vector<ConflictSet> conflictSets;  ///< the smallest sets that it conflicts with or repeats, and repairs
  /// How far vertices move, all together, for a unit of change in what one of its rows asks for; none when disabled.
  std::optional<double> sensitivity;
  /// From its `near` places to the surface, the largest; none where it names none or is disabled. Model units.
  std::optional<double> nearDistance;
  std::optional<double> multiplier;  ///< how hard it pulls, without units: see docs/math.md; of solved hard constraints
  Index dependsOnCount = 0;          ///< how many constraints there are in `dependsOn`, listed or not
};

/// The outcomes of all constraints, in the order of the list. They are made when somebody first looks at one of them,
/// once for all copies; any thread may do so.
class ConstraintOutcomes {
 public:
  ConstraintOutcomes(std::vector<ConstraintOutcome> outcomes = {});
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

enum class SolveStatus {
  NotRun,
  Ok,         ///< every constraint that can be met is met
  Conflicts,  ///< solved with the conflicting rows left out
  Failed      ///< no usable solution; `message` says why
};

[[nodiscard]] std::string_view name(SolveStatus status);

struct Seconds {
  double setup = 0;          ///< triangulation, operators, rows of constraints
  double factorization = 0;  ///< elimination and factorisation
  double solution = 0;       ///< per set of targets
};

/// How rotations were found.
struct RotationIterations {
  int count = 0;
  double change = 0;  ///< how far the last one moved a vertex at most, as a share of `RotationEnergy::size`
  bool isConverged = false;
};

struct SolveReport {
  SolveStatus status = SolveStatus::NotRun;
  std::string message;
  double maxResidual = 0;          ///< of all constraints that are not disabled or conflicting, model units
  double maxResidualRelative = 0;  ///< the same as a share of the bounding box's diagonal
  Weights weights = Weights::Cotangent;
  SolverOptions options;
  std::string method;  ///< how the factor was made
  Index unknowns = 0;
  Index factorNonzeros = 0;
  int refinementSteps = 0;
  double accuracy = 0;                        ///< estimated relative error of the displacements
  std::optional<double> rotationAccuracy;     ///< that of the rotation field; none where none was solved for
  std::optional<double> disagreementDegrees;  ///< of rotations given in one rigid region: the largest difference
  RotationSource rotations = RotationSource::Given;
  std::optional<RotationIterations> iterations;  ///< of rotations that were found
  Seconds seconds;
};

struct Report {
  MeshReport mesh;
  ConstraintOutcomes constraints;
  SolveReport solve;
  std::vector<SkippedRow> skippedRows = {};  ///< of the point list that the constraints come from; set by its reader
  ResultVerdict result = {};                 ///< what the solution made of the part
};

}  // namespace holdfast
