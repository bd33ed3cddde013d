#pragma once
/// Rows with directions, eliminated along each set of axes by itself.

#include <bitset>
#include <memory>
#include <vector>

#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// The elimination of the rows that hold along some axes of a frame.
struct AxisElimination {
  std::bitset<3> axes;      ///< columns of the frame
  std::vector<Index> rows;  ///< of each of its rows: the place in the whole system, ascending
  std::shared_ptr<const EliminatedConstraints> eliminated;
};

/// The eliminations of one list of rows. They have no axis in common, and each is a scalar problem of its own, see
/// `axisSystems`. Without directions there is one, of all rows along all axes.
///
///     const EliminatedByAxes eliminated(system, mesh, kRankTolerance);
///     std::vector<KnownGaps> none;
///     const Diagnosis diagnosis = diagnose(eliminated, system, mesh, none);
class EliminatedByAxes {
 public:
  /// Eliminates the rows of `system`, which must have a `commonFrame`. Rows closer to the rows before them than
  /// `tolerance` are left out.
  EliminatedByAxes(const ConstraintSystem& system, const SolverMesh& mesh, double tolerance);

  [[nodiscard]] const Eigen::Matrix3d& frame() const noexcept { return frame_; }
  [[nodiscard]] const std::vector<AxisElimination>& parts() const noexcept { return parts_; }

  /// Tells whether all rows hold in all directions.
  [[nodiscard]] bool isOne() const noexcept { return parts_.size() == 1; }

  /// Returns the elimination of the rows that hold in all directions; the others have no terms in it. Rotations that
  /// constraints decide are found by it. It is that of a part where no row turns.
  [[nodiscard]] const EliminatedConstraints& inAllDirections() const noexcept { return *inAllDirections_; }

  /// Returns how many unknowns are left, counted once for each set of axes.
  [[nodiscard]] Index freeCount() const;

  /// Returns for each unknown whether it stays at rest along all axes.
  [[nodiscard]] std::vector<bool> isHeld() const;

  /// Returns what each part is asked where all rows are asked for `ofRows` (rows x 3, model coordinates). Parts have
  /// coordinates of the frame.
  [[nodiscard]] std::vector<Columns3> takenApart(const Columns3& ofRows) const;

  /// Returns the part of `values` (n x 3, model coordinates) along the axes of part `k`, by coordinates of the frame.
  [[nodiscard]] Columns3 along(std::size_t k, Columns3 values) const;

  /// Adds up the solutions of all parts (n x 3 each, coordinates of the frame). Returns the sum in model coordinates.
  [[nodiscard]] Columns3 joined(std::vector<Columns3> ofParts) const;

  /// Returns `Elimination::sensitivities` of all rows. A row that holds along axes of several parts has the largest.
  [[nodiscard]] std::vector<double> sensitivities() const;

  /// Returns `Elimination::multipliers` of all rows, rows x 3, in model coordinates.
  [[nodiscard]] Columns3 multipliers(const Columns3& gradient) const;

 private:
  Eigen::Matrix3d frame_;
  std::vector<AxisElimination> parts_;
  std::shared_ptr<const EliminatedConstraints> inAllDirections_;
  Index rowCount_;
};

/// Diagnoses `system` part by part. It has the rows that were eliminated. A row conflicts where it does so along some
/// axes. It is redundant where it is so along all axes along which it holds. A row that depends on others in several
/// parts has several entries in `Diagnosis::dependent`. `known` is empty, or comes from an earlier call with the same
/// `eliminated`.
[[nodiscard]] Diagnosis diagnose(const EliminatedByAxes& eliminated, const ConstraintSystem& system,
                                 const SolverMesh& mesh, std::vector<KnownGaps>& known);
[[nodiscard]] inline Diagnosis diagnose(const EliminatedByAxes& eliminated, const ConstraintSystem& system,
                                        const SolverMesh& mesh)
{
  std::vector<KnownGaps> none;
  return diagnose(eliminated, system, mesh, none);
}

}  // namespace holdfast
