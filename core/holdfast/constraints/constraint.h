#pragma once
/// \file
/// Constraints as a user states them: one entry of a constraint file each, in the file's own terms.
/// `constraint_system.h` makes rows of B and d of them.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <holdfast/constraints/selection.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

/// Every selected vertex stays where it is: p at rest, q = 0.
struct Fixed {
  Selection select;
};

/// A turn by `degrees` (any number of turns) about the line through `center` along `axis` (not zero, any length).
struct Turn {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0;
  std::optional<Vector3> center;  ///< the centroid of the selected vertices at rest where absent
};

/// Every selected vertex goes where a rigid motion takes it: p = R (p0 - center) + center + translate.
struct Handle {
  Selection select;
  std::optional<Turn> rotate;
  Vector3 translate = Vector3::Zero();
};

/// Where a point goes: to a place, or by a shift from where it is at rest; model units.
struct Target {
  Vector3 place = Vector3::Zero();
};
struct Move {
  Vector3 shift = Vector3::Zero();
};

/// One point of the surface goes to one place.
struct Point {
  SurfaceLocation at;
  std::variant<Target, Move> to;
};

/// The selected vertices move as one body, wherever the rest takes it, equations (28) and (29).
struct Rigid {
  Selection select;
};

/// p_from - p_to keeps its rest vector, or takes `offset`, Fig. 8.
struct Relative {
  SurfaceLocation from;
  SurfaceLocation to;
  std::optional<Vector3> offset;
};

/// One entry of a constraint file.
struct Constraint {
  std::string name;  ///< unique in its list
  bool isEnabled = true;
  std::variant<Fixed, Handle, Point, Rigid, Relative> what;
};

/// The name of the constraint's type in files and reports: "fixed", "handle", "point", "rigid", "relative".
[[nodiscard]] const char* typeName(const Constraint& constraint);

/// A whole constraint file. The order is that of precedence: of several that cannot all hold, the earlier stand.
struct ConstraintList {
  std::string units;  ///< as the user calls them ("mm"); may be empty
  std::vector<Constraint> constraints;
};

}  // namespace holdfast
