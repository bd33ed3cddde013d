#pragma once
/// \file
/// Which rows hold, which repeat others and which contradict them, and by how much.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/dependency.h>
#include <holdfast/elimination/elimination.h>

namespace holdfast {

enum class RowStatus {
  Independent,  ///< enforced
  Redundant,    ///< follows from rows before it, and agrees with them
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
  /// The redundant rows, when the independent ones alone would miss some of them: see
  /// `Elimination::reconciledParticular`.
  std::vector<Index> reconciled;

  [[nodiscard]] bool hasConflicts() const;
};

/// A dependent row agrees with its partners when changing what each of them asks for by no more than this share of the
/// bounding box's diagonal closes the gap: half of the residual that is promised, the other half being left to
/// rounding. Pins are not changed: they are copied.
inline constexpr double kConsistentGap = 5e-13;

/// The largest residual of a constraint that is met, in model units: 1e-12 of the diagonal, or, where the coordinates
/// are so large that doubles lie farther apart than that, eight times their spacing.
[[nodiscard]] double residualLimit(const SolverMesh& mesh, const ConstraintSystem& system);

/// What the decomposition of section 5 finds out about the rows from topology and barycentric numbers alone: it does
/// not change when targets do.
struct EliminatedConstraints {
  std::vector<RowTerms> rows;            ///< of B; those of parts at rest are empty
  std::vector<Dependency> dependencies;  ///< the rows that follow from rows before them, ascending
  std::vector<bool> isHeld;              ///< unknowns of parts that no row places: they stay at rest
  Elimination elimination;               ///< of the independent rows
};

[[nodiscard]] EliminatedConstraints eliminate(const ConstraintSystem& system, const SolverMesh& mesh);

/// Judges the dependent rows by their gaps at the targets of `system`, which has the rows that were eliminated.
/// O(rows).
[[nodiscard]] Diagnosis diagnose(const EliminatedConstraints& eliminated, const ConstraintSystem& system,
                                 const SolverMesh& mesh);

/// d - B p for every row, as the solver takes them: rows x 3.
[[nodiscard]] Columns3 shiftsOf(const ConstraintSystem& system);

}  // namespace holdfast
