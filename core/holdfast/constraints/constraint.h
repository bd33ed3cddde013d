#pragma once
/// Constraints as a user states them: one entry of a constraint file each, in the file's own terms.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <holdfast/constraints/selection.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

/// Every selected vertex stays where it is: p at rest, q = 0.
struct FixedConstraint {
  static constexpr const char* kType = "fixed";
  Selection select;
};

/// A turn by `degrees` (any number) about the line through `center` along `axis` (not zero, any length).
struct AxisRotation {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0;
  std::optional<Vector3> center;  ///< the centroid of the selected vertices at rest where absent
};

/// A turn by `degrees` (any number) about `axis` (not zero, any length).
struct AxisAngle {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0;
};

/// The shortest rotation that takes the handle from where the fixed vertices see it to where they see it after
/// `HandleConstraint::translate`, centroid from centroid, at rest; about the handle's own centroid.
struct RotationAboutFixed {
  /// Of the turns that make this rotation, apart by whole turns, the nearest to this is meant, the shortest without it.
  /// Where both directions are opposite, the axis across them that is nearest to this one is taken.
  std::optional<AxisAngle> near;
};

/// A right-handed frame in space: z is across x and y, and y is made perpendicular to x. Neither is zero, nor are they
/// parallel; their lengths do not matter.
struct Frame {
  std::optional<Vector3> origin;
  Vector3 x = Vector3::UnitX();
  Vector3 y = Vector3::UnitY();
};

/// The rigid motion that takes `from` to `to` by the shortest rotation and `turns` whole turns about its axis more.
struct FrameMotion {
  Frame from;       ///< its origin: the centroid of the selected vertices at rest where absent
  Frame to;         ///< its origin: that of `from` where absent
  Index turns = 0;  ///< other than 0 only where the rotation has an axis
};

/// A place for each vertex, three or more, in the order of the selection, which has to be distinct `VertexIds`. They
/// turn by the rotation that fits best.
struct VertexTargets {
  std::vector<Vector3> places;
};

/// Every selected vertex goes where `motion` takes it, or stays where there is none, and then by `translate`. The
/// rotation of the motion, none where there is none, is handed on to the surface.
struct HandleConstraint {
  static constexpr const char* kType = "handle";
  Selection select;
  std::variant<std::monostate, AxisRotation, RotationAboutFixed, FrameMotion, VertexTargets> motion;
  Vector3 translate = Vector3::Zero();
  /// What each vertex hands on to the surface in place of that: one for each of distinct `VertexIds`, or none at all.
  std::vector<AxisAngle> rotations;
};

/// A point goes to a place; model units.
struct Target {
  Vector3 place = Vector3::Zero();

  [[nodiscard]] Vector3 placeFrom(const Vector3& /*rest*/) const { return place; }
  [[nodiscard]] Vector3 shiftFrom(const Vector3& rest) const { return place - rest; }
};

/// A point goes by a shift from where it is at rest; model units.
struct Move {
  Vector3 shift = Vector3::Zero();

  [[nodiscard]] Vector3 placeFrom(const Vector3& rest) const { return rest + shift; }
  [[nodiscard]] Vector3 shiftFrom(const Vector3& /*rest*/) const { return shift; }
};

/// One point of the surface goes to one place.
struct PointConstraint {
  static constexpr const char* kType = "point";
  SurfaceLocation at;
  std::variant<Target, Move> to;
};

/// Where a point goes that is at `rest`, bit for bit as the solver takes it.
[[nodiscard]] inline Vector3 placeOf(const PointConstraint& point, const Vector3& rest)
{
  return std::visit([&](const auto& to) { return to.placeFrom(rest); }, point.to);
}

/// By how much a point moves that is at `rest`, bit for bit as the solver takes it.
[[nodiscard]] inline Vector3 shiftOf(const PointConstraint& point, const Vector3& rest)
{
  return std::visit([&](const auto& to) { return to.shiftFrom(rest); }, point.to);
}

/// The vectors between the selected vertices are kept and their rotations are equal, equations (28) and (29).
struct RigidConstraint {
  static constexpr const char* kType = "rigid";
  Selection select;
};

/// p_from - p_to keeps its rest vector, or takes `offset`, Fig. 8.
struct RelativeConstraint {
  static constexpr const char* kType = "relative";
  SurfaceLocation from;
  SurfaceLocation to;
  std::optional<Vector3> offset;
};

/// Something that a file says of a constraint and that means nothing to the solution: a column of a point list.
struct ExtraText {
  std::string title;  ///< not empty
  std::string text;

  friend bool operator==(const ExtraText&, const ExtraText&) = default;
};

/// One entry of a constraint file.
struct Constraint {
  std::string name;  ///< unique in its list
  bool isEnabled = true;
  std::variant<FixedConstraint, HandleConstraint, PointConstraint, RigidConstraint, RelativeConstraint> what;
  std::vector<ExtraText> extra = {};  ///< kept for the files that are written from it; titles differ
};

/// The name of the constraint's type in files and reports.
[[nodiscard]] inline const char* typeName(const Constraint& constraint)
{
  return std::visit([](const auto& what) { return what.kType; }, constraint.what);
}

/// The selection of a constraint that has one; null for others.
[[nodiscard]] inline const Selection* selectionOf(const Constraint& constraint)
{
  return std::visit(
      [](const auto& what) -> const Selection* {
        if constexpr (requires { what.select; })
          return &what.select;
        else
          return nullptr;
      },
      constraint.what);
}

/// A whole constraint file. The order is that of precedence: where not all can hold, earlier ones do.
struct ConstraintList {
  std::string units;  ///< as the user calls them ("mm"); may be empty
  std::vector<Constraint> constraints;
};

}  // namespace holdfast
