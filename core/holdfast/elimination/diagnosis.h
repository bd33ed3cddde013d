#pragma once
/// Which rows hold, which repeat others and which contradict them, and by how much.

#include <map>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/elimination.h>
#include <holdfast/elimination/find_dependencies.h>

namespace holdfast {

enum class RowStatus {
  Independent,  ///< enforced
  Redundant,    ///< follows from rows before it, and agrees with them, or nearly follows and may agree
  Conflicting   ///< follows from rows before it, and asks for something else: left out
};

/// A dependent row, its circuit, and d_j - sum a_k d_k: what is missing between what it asks for and what the rows
/// before it imply, in model units.
struct DependentRow {
  Dependency dependency;
  Vector3 gap = Vector3::Zero();
};

struct Diagnosis {
  std::vector<RowStatus> status;        ///< of each row
  std::vector<DependentRow> dependent;  ///< ascending by row
  std::vector<double> limits;  ///< of each row: the largest residual with which it is met, see `residualLimits`
  bool isNearOrigin = false;   ///< then they are the promised residual, whatever the displacement
  /// The redundant rows that the independent ones alone miss by more than rounding, when they would miss some of them
  /// by more than their limits: see `reconciledParticular`.
  std::vector<Index> reconciled;
  /// Of conflicting rows whose gap depends on rotations, where these were found: by row, those that it contradicts.
  std::map<Index, std::vector<Index>> reasons;
  /// The conflicting rows that would be met where rotations are found, ascending; none where they were.
  std::vector<Index> metIfFound;
  Columns3 particular;  ///< `Elimination::particular` of the shifts, where gaps were read off it; else no rows

  [[nodiscard]] bool hasConflicts() const;
};

/// The residual that is promised, as a share of the bounding box's diagonal.
inline constexpr double kPromisedResidual = 1e-12;

/// Where doubles lie farther apart than that, this many epsilon of the largest number in a row are promised: what
/// rounding of three stored places, of their weighted sum and of its target can come to.
inline constexpr double kPromisedSpacings = 8;

/// A dependent row agrees with its terms when changing what each of them asks for by no more than this share of its
/// limit closes the gap; the rest is left to rounding. Pins are not changed: they are copied.
inline constexpr double kConsistentShare = 0.5;

/// The largest residual with which each row is met, in model units: `kPromisedResidual` of the diagonal or, if that is
/// more, `kPromisedSpacings` epsilon of the largest of the row's own numbers. These are the coordinates of its target
/// and the sums of its unknowns' coordinates times the size of their weights, at rest and displaced by `u` (n x 3; at
/// rest where that has no rows), the latter up to the largest coordinate that is asked for. For a dependent row the
/// numbers of its terms count as well. O(terms).
[[nodiscard]] std::vector<double> residualLimits(const SolverMesh& mesh, const ConstraintSystem& system,
                                                 const std::vector<DependentRow>& dependent, const Columns3& u);

/// What the decomposition of section 5 finds out about the rows from topology and barycentric numbers alone: it does
/// not change when targets do.
struct EliminatedConstraints {
  std::vector<RowTerms> rows;            ///< of B; those of parts at rest are empty
  std::vector<Dependency> dependencies;  ///< the rows that follow from rows before them, ascending
  std::vector<bool> isHeld;              ///< unknowns of parts that no row places: they stay at rest
  Elimination elimination;               ///< of the independent rows
};

/// Rows closer to the rows before them than `tolerance` are left out, see `kRankTolerance`.
[[nodiscard]] EliminatedConstraints eliminate(const ConstraintSystem& system, const SolverMesh& mesh,
                                              double tolerance = kRankTolerance);

/// Gaps, and what the rows asked for that they depend on: in most frames of a drag both stay as they are.
struct KnownGaps {
  std::vector<Index> rows;
  Columns3 shifts;
  std::vector<DependentRow> gaps;
};

/// Classifies the dependent rows by their gaps at the targets of `system`, which has the rows that were eliminated.
/// `known` is of an earlier call with the same `eliminated`, or empty, and becomes what was found now.
[[nodiscard]] Diagnosis diagnose(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                 const SolverMesh& mesh, KnownGaps& known);
[[nodiscard]] inline Diagnosis diagnose(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                        const SolverMesh& mesh)
{
  KnownGaps none;
  return diagnose(eliminated, system, mesh, none);
}

/// The largest gap of each dependent row that is rounding, model units, in the order of `eliminated.dependencies`.
[[nodiscard]] std::vector<double> agreeingGaps(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                               const SolverMesh& mesh);

/// d - B p for every row, as the solver takes them: rows x 3.
[[nodiscard]] Columns3 shiftsOf(const ConstraintSystem& system);

}  // namespace holdfast
