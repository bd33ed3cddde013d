#pragma once
/// Tolerances say what the offsets of points from their stated targets may be.

#include <vector>

#include <holdfast/elimination/axis_elimination.h>
#include <holdfast/solve/allowed_places.h>

namespace holdfast {

/// The units of offsets in a choice of places: coordinates of a frame, and lengths in diagonals.
struct ToleranceUnits {
  const Eigen::Matrix3d& frame;
  double diagonal = 0;     ///< of the mesh, model units
  double weightScale = 1;  ///< weights are for rows that are so many times those of the energy, see `rowsInDiameters`
};

/// Returns what the tolerance of a row allows. `directions` are those of the row, in model coordinates.
[[nodiscard]] AllowedOffset allowedOffset(const TolerantRow& tolerant, const RowDirections& directions,
                                          const ToleranceUnits& units);

/// Gives each tolerant row the target at its offset from the stated one (rows x 3, model coordinates and units). Balls
/// and boxes hold to the last bit.
void takeOffsets(ConstraintSystem& system, const Positions& offsets);

/// Returns the rows of all tolerant points, in their order.
[[nodiscard]] std::vector<Index> rowsOfTolerant(const ConstraintSystem& system);

/// Returns the place that a row of the whole system has in a part.
[[nodiscard]] Index rowInPart(const AxisElimination& part, Index row);

}  // namespace holdfast
