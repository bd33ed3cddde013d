#pragma once
/// The points that have tolerances or weights, and where they go.

#include <map>
#include <vector>

#include <Eigen/Dense>

#include <holdfast/deform/forces.h>
#include <holdfast/elimination/axis_elimination.h>
#include <holdfast/solve/axis_solvers.h>
#include <holdfast/threads/progress.h>

namespace holdfast {

/// How far the displacement of one part reaches when tolerant points move by 1, each alone.
using Reach = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// How the pulls of the tolerant rows of one part grow with their displacements, and how the surface follows these.
struct PartStiffness {
  std::vector<Index> rows;        ///< of all tolerant rows, in their order
  std::vector<Index> points;      ///< places in `ConstraintSystem::tolerant` of those that follow from no other rows
  Eigen::MatrixXd matrix;         ///< points x points: lengths in diagonals
  Reach reach = {};               ///< unknowns x points; empty where all parts together would take too much memory
  Reach reachOfMultipliers = {};  ///< kept rows x points; empty where `reach` is
};

/// Tells whether it is the stiffness of the tolerant rows of `system`, whatever their targets and tolerances.
[[nodiscard]] bool areOfSameRows(const std::vector<PartStiffness>& stiffness, const ConstraintSystem& system);

/// Returns the stiffness of each part by solving for unit displacements, three at a time: O(points / 3) solutions.
/// Throws what `progress` throws.
[[nodiscard]] std::vector<PartStiffness> stiffnessOf(const ConstraintSystem& system, const AxisSolvers& solvers,
                                                     const EnergyMatrix& A, const ActedOn& actedOn, Progress& progress);

/// Returns a stiffness without a surface: each point would rather be at its target.
[[nodiscard]] std::vector<PartStiffness> looseStiffness(const ConstraintSystem& system,
                                                        const EliminatedByAxes& eliminated);

/// `chooseTargets` chooses places by these.
struct PlaceChoice {
  const EliminatedByAxes& eliminated;
  const std::vector<PartStiffness>& stiffness;
  double diagonal = 0;     ///< of the mesh, model units
  double weightScale = 1;  ///< as in `ToleranceUnits`
};

/// The rows that a row contradicts, a smallest set.
using Contradictions = std::map<Index, std::vector<Index>>;

/// The choice of places names contradictions, and has notes about constraints.
struct ChosenPlaces {
  Contradictions contradictions;      ///< of rows whose directions contradict those of rows before them
  std::vector<ConstraintNote> notes;  ///< about points on surfaces
};

/// Gives the tolerant rows of `system` the targets of the least energy that are near enough. `pulls` (rows x 3, lengths
/// in diagonals) are the multipliers of all rows at the targets that the rows have.
ChosenPlaces chooseTargets(ConstraintSystem& system, const PlaceChoice& choice, const Columns3& pulls);

/// Returns what the tolerant rows of `system` ask for, rows x 3.
[[nodiscard]] Columns3 tolerantShifts(const ConstraintSystem& system);

/// Takes `displacement`, a solution for what tolerant rows asked for `before`, to that for what they ask for now.
/// False, and nothing is done, where no reach is known. O(unknowns * points).
[[nodiscard]] bool followTargets(const ConstraintSystem& system, const Columns3& before,
                                 const EliminatedByAxes& eliminated, const std::vector<PartStiffness>& stiffness,
                                 Displacement& displacement);

}  // namespace holdfast
