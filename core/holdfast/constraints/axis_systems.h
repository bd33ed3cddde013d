#pragma once
/// Rows with directions as scalar problems: one for each axis of an orthonormal frame.

#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include <holdfast/constraints/constraint_system.h>

namespace holdfast {

/// Returns the rows whose directions are at odds with the axes of most rows, ascending. Directions are at odds where
/// they are neither parallel nor square to 1e-14. The axes are found one after the other: each is that of most rows
/// among those that are square to the axes before it. The coordinate axes are taken where hardly more rows are at odds
/// with them. O(rows times directions that differ).
[[nodiscard]] std::vector<Index> rowsAtOdds(const std::vector<ConstraintRow>& rows);

/// Returns an orthonormal frame that fits all rows: its columns are axes, and each row with a direction holds along one
/// of them or across one. These are the coordinate axes where they do. Returns none where directions are at odds.
/// O(rows).
[[nodiscard]] std::optional<Eigen::Matrix3d> commonFrame(const std::vector<ConstraintRow>& rows);

/// The rows that hold along some axes of a frame, as a system of its own.
struct AxisSystem {
  std::bitset<3> axes;      ///< columns of the frame
  std::vector<Index> rows;  ///< of each row: its place in the whole system
  ConstraintSystem system;  ///< rows alone: shifts by coordinates of the frame, 0 along other axes
};

/// Returns `system` as one, two or three systems that have no axis in common. The energy |A u - f|^2 is a sum over the
/// coordinates of any orthonormal frame, and so each of these systems is solved alone, by an elimination and a factor
/// of its own. Axes along which the same rows hold share one. `frame` fits all rows, see `commonFrame`. Without
/// directions there is one system: all rows, as they are, along all axes of the identity. O(terms).
[[nodiscard]] std::vector<AxisSystem> axisSystems(const ConstraintSystem& system, const Eigen::Matrix3d& frame);

/// Tells whether a tolerance, and the `directions` of its row, ask something of each coordinate by itself.
[[nodiscard]] bool isByCoordinates(const TolerantRow& tolerant, const RowDirections& directions);

/// Returns the part of `values` (n x 3, model coordinates) along the axes of one system, by coordinates of the frame.
/// The other columns are 0.
[[nodiscard]] Columns3 alongAxes(Columns3 values, const std::bitset<3>& axes, const Eigen::Matrix3d& frame);

/// Returns what was found for all systems (n x 3 each, coordinates of the frame) in model coordinates. Where the frame
/// is the identity, numbers keep their bits.
[[nodiscard]] Columns3 joinedAxes(std::vector<Columns3> ofSystems, const Eigen::Matrix3d& frame);

}  // namespace holdfast
