#pragma once
/// How near a point has to come to its target.

#include <limits>
#include <optional>
#include <string>
#include <variant>

#include <holdfast/constraints/row_directions.h>
#include <holdfast/numbers/types.h>

namespace holdfast {

/// The point goes to its target exactly.
struct Exactly {};

/// The point comes as near to its target as `radius`, or nearer. It is above 0, in model units. The target of a point
/// on a plane, a line or a surface is the nearest place there.
struct WithinBall {
  double radius = 0;
};

/// Along each coordinate axis the point comes as near to its target as this, or nearer. All are above 0, in model
/// units.
struct WithinBox {
  Vector3 half = Vector3::Zero();
};

/// The point stays between two planes across `normal` (not zero, of any length). They lie `low` and `high` from its
/// target along the normal, in model units. `low` is less than `high`, and one of them may be infinite.
struct WithinSlab {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::optional<Vector3> normal;  ///< absent for points on a plane or a surface, which has one of its own
};

/// The point comes as near to its target as that is worth beside the energy of the surface. `weight` is the weight w of
/// soft constraints, (7) and (8), for models measured in diameters of the smallest sphere around them. It is above 0.
struct Weighted {
  double weight = 1;
};

using PointTolerance = std::variant<Exactly, WithinBall, WithinBox, WithinSlab, Weighted>;

/// An error says what cannot be in a tolerance: the key at fault below that of the constraint (".within.ball"), and
/// why.
struct ToleranceError {
  std::string key;
  std::string reason;
};

/// Returns what contradicts the bounds above for points that are held in these `directions`. Points on planes and lines
/// have tolerances across these.
[[nodiscard]] std::optional<ToleranceError> validateTolerance(const PointTolerance& tolerance,
                                                              const RowDirections& directions);

}  // namespace holdfast
