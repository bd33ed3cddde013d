#pragma once
/// A diagnosis says which rows hold, which repeat others and which contradict them, and by how much.

#include <algorithm>
#include <map>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/elimination.h>
#include <holdfast/elimination/find_dependencies.h>

namespace holdfast {

enum class RowStatus {
  Independent,  ///< enforced
  Redundant,    ///< follows from earlier rows and agrees with them, or nearly follows and may agree
  Conflicting   ///< follows from earlier rows and asks for something else: left out
};

/// A dependent row with its circuit and its gap. The gap is d_j - sum a_k d_k: what the row asks for, less what the
/// rows before it imply, in model units.
struct DependentRow {
  Dependency dependency;
  Vector3 gap = Vector3::Zero();
  bool isConflicting = false;  ///< along the axes of this dependency
};

/// A solver meets these targets of the rows of its elimination.
struct RowTargets {
  Columns3 shifts;                ///< d of B u = d, for every row
  std::vector<Index> reconciled;  ///< the redundant rows that the independent ones alone would miss, and those that
                                  ///< share circuits with them: hard constraints meet them by `reconciledParticular`
  Columns3 particular = {};       ///< `Elimination::particular` of the shifts where that is known; else no rows
};

/// Tells whether rows are to be reconciled.
[[nodiscard]] inline bool isReconciled(const std::vector<RowTargets>& targets)
{
  return std::ranges::any_of(targets, [](const RowTargets& some) { return !some.reconciled.empty(); });
}

struct Diagnosis {
  std::vector<RowStatus> status;        ///< of each row
  std::vector<DependentRow> dependent;  ///< ascending by row
  std::vector<double> limits;       ///< of each row: the largest residual with which it is met, see `residualLimits`
  bool isNearOrigin = false;        ///< then each limit is the promised residual, whatever the displacement
  std::vector<RowTargets> targets;  ///< one for each elimination of the rows, see `EliminatedByAxes`
  /// The rows that each conflicting row contradicts, if its gap depends on rotations. The map is filled if rotations
  /// were found.
  std::map<Index, std::vector<Index>> reasons;
  /// The conflicting rows that would be met if rotations were found, ascending. None where they were found.
  std::vector<Index> metIfFound;

  [[nodiscard]] bool hasConflicts() const;
};

/// The solver promises this residual, as a share of the diagonal of the bounding box.
inline constexpr double kPromisedResidual = 1e-12;

/// Where doubles lie farther apart than that residual, this many epsilon of the largest number in a row are promised.
/// Three stored places, their weighted sum and its target can come to so much rounding.
inline constexpr double kPromisedSpacings = 8;

/// A dependent row agrees with its terms if small changes of their targets close its gap. A change is small up to this
/// share of the term's limit; the rest is left to rounding. Pins do not change, because the solution copies them.
inline constexpr double kConsistentShare = 0.5;

/// Returns the largest residual with which each row is met, in model units. It is `kPromisedResidual` of the diagonal
/// or, if that is more, `kPromisedSpacings` epsilon of the largest of the row's own numbers.
///
/// These numbers are the coordinates of the row's target, and sums of its unknowns' coordinates times the size of their
/// weights. The sums are taken at rest and displaced by `u` (n x 3; no rows: at rest). The displaced ones count up to
/// the largest coordinate that is asked for. For a dependent row the numbers of its terms count as well. O(terms).
[[nodiscard]] std::vector<double> residualLimits(const SolverMesh& mesh, const ConstraintSystem& system,
                                                 const std::vector<DependentRow>& dependent, const Columns3& u);

/// What the decomposition of section 5 finds out about the rows. It uses topology and barycentric numbers alone, so it
/// does not change when targets do.
struct EliminatedConstraints {
  std::vector<RowTerms> rows;            ///< of B; those of parts at rest are empty
  std::vector<Dependency> dependencies;  ///< the rows that follow from rows before them, ascending
  std::vector<bool> isHeld;              ///< unknowns of parts that no row places: they stay at rest
  Elimination elimination;               ///< of the independent rows
};

/// Eliminates the rows of `system`. Rows closer to the rows before them than `tolerance` are left out, see
/// `kRankTolerance`.
[[nodiscard]] EliminatedConstraints eliminate(const ConstraintSystem& system, const SolverMesh& mesh,
                                              double tolerance = kRankTolerance);

/// Gaps, and what the rows that they depend on asked for. In most frames of a drag both stay as they are.
struct KnownGaps {
  std::vector<Index> rows;
  Columns3 shifts;
  std::vector<DependentRow> gaps;
};

/// Classifies the dependent rows by their gaps at the targets of `system`. `system` has the rows that were eliminated.
/// `known` is empty, or comes from an earlier call with the same `eliminated`. The call replaces it by what it finds.
[[nodiscard]] Diagnosis diagnose(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                 const SolverMesh& mesh, KnownGaps& known);
[[nodiscard]] inline Diagnosis diagnose(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                        const SolverMesh& mesh)
{
  KnownGaps none;
  return diagnose(eliminated, system, mesh, none);
}

/// Returns for each dependent row the largest gap that is rounding, in model units. The order is that of
/// `eliminated.dependencies`.
[[nodiscard]] std::vector<double> agreeingGaps(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                               const SolverMesh& mesh);

/// Returns d - B p for every row, as the solver takes them: rows x 3.
[[nodiscard]] Columns3 shiftsOf(const ConstraintSystem& system);

}  // namespace holdfast
