#pragma once
/// Places of many points with tolerances, chosen along each axis by itself.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <holdfast/solve/axis_solvers.h>
#include <holdfast/solve/bounded_rows.h>
#include <holdfast/threads/progress.h>

namespace holdfast {

/// Tells whether the tolerant rows of `system` are chosen along each axis by itself: where there are more than
/// `kMostTolerantPoints`.
[[nodiscard]] inline bool areSeparate(const ConstraintSystem& system)
{
  return system.tolerant.size() > kMostTolerantPoints;
}

/// The problems along each axis, one for each part.
struct SeparatePlaces {
  std::vector<Index> rows;  ///< of all tolerant rows, in their order
  std::vector<BoundedRows> parts;
  std::string failure;  ///< why there are none
};

[[nodiscard]] SeparatePlaces separatePlaces(const ConstraintSystem& system, const EliminatedByAxes& eliminated,
                                            std::shared_ptr<const EnergyMatrix> A);

/// A frame for which `chooseSeparately` chooses places.
struct SeparateChoice {
  const AxisSolvers& solvers;
  const SeparatePlaces& places;
  double diagonal = 0;                                 ///< of the mesh, model units
  double weightScale = 1;                              ///< as in `PlaceChoice`
  const Columns3& f;                                   ///< what A u is to be near
  std::function<Columns3(const Columns3& u)> pullsAt;  ///< multipliers of all rows, rows x 3: lengths in diagonals
};

/// Does what `chooseTargets` does for rows that are `areSeparate`, by some 20 factors of one axis for each of the
/// three. Returns why that cannot be done, or nothing. Throws what `progress` throws.
[[nodiscard]] std::string chooseSeparately(ConstraintSystem& system, const SeparateChoice& choice, Progress& progress);

}  // namespace holdfast
