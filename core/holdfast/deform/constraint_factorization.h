#pragma once
/// All that the structure of a set of constraints costs, for any targets: the second of the three calls of section 6.

#include <future>
#include <memory>
#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/deform/forces.h>
#include <holdfast/deform/rotation_factorization.h>
#include <holdfast/deform/separate_places.h>
#include <holdfast/deform/tolerant_points.h>
#include <holdfast/elimination/axis_elimination.h>
#include <holdfast/rotation/rotation_energy.h>
#include <holdfast/solve/axis_solvers.h>
#include <holdfast/solve/moved_solutions.h>
#include <holdfast/threads/long_step.h>

namespace holdfast {

/// The operators of a model, which serve any constraints.
struct ModelOperators {
  std::shared_ptr<const Operators> operators;
  std::shared_ptr<const RotationEnergy> energy;  ///< null where rotations are given
  std::shared_ptr<const EnergyMatrix> A;
};

/// Rows are left out where they are closer to others than this at most, see `FactorStore::withFewerRows`: it keeps
/// amplification below some thousands.
inline constexpr double kLargestNeededDistance = 1e-3;

/// The elimination of one set of rows and, once they are asked for, the factors of positions and rotations.
struct ConstraintFactorization {
  /// Leaves out rows that are closer to those before them than `itsTolerance`. `ranks` is the order of elimination.
  ConstraintFactorization(std::shared_ptr<const Model> model, const ModelOperators& of, const std::vector<int>& ranks,
                          const ConstraintSystem& itsSystem, const DeformOptions& options, double itsTolerance);

  /// The same under the constraints of `wanted`, by the factor of `base`, bordered.
  ConstraintFactorization(const ConstraintFactorization& wanted, std::shared_ptr<ConstraintFactorization> base);

  /// Tells whether `other` has the rows, given rotations and rigid regions that this was made of. O(terms).
  [[nodiscard]] bool serves(const ConstraintSystem& other) const;

  /// Tells whether `other` has the same given rotations, rigid regions and flat unknowns.
  [[nodiscard]] bool turnsAs(const ConstraintSystem& other) const;

  /// Tells whether the same rows stand in both.
  [[nodiscard]] bool standsOn(const ConstraintFactorization& other) const;

  /// Tells whether it has a factor, and it can be used.
  [[nodiscard]] bool isReady();

  /// Returns how far a unit of change in what one row asks for moves the vertices at most; 1 without rows.
  [[nodiscard]] double largestSensitivity() const;

  ConstraintSystem system;
  double tolerance;
  std::shared_ptr<const EliminatedByAxes> eliminated;
  std::shared_ptr<const std::vector<double>> sensitivities;  ///< of rows, see `Elimination::sensitivities`
  bool mayHaveFewerRows;                 ///< rows that nearly depend on others may go where not all are met
  std::vector<KnownGaps> knownGaps;      ///< of each part of `eliminated`
  std::shared_future<ActedOn> actedOn;   ///< made with the first forces
  std::vector<PartStiffness> stiffness;  ///< of tolerant points, of each part; made with the first places
  SeparatePlaces separate;               ///< in its place where there are too many of them
  std::shared_ptr<RotationFactorization> rotations;
  LongStep<AxisSolversResult> positions;
  std::vector<MovedSolutions> moved;  ///< of each part, where solutions may be sums of earlier ones; else none
  bool isBordered = false;
  bool isForOneCall = false;  ///< the factor of rotations is released before that of positions takes memory
};

}  // namespace holdfast
