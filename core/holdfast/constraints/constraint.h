#pragma once
/// Constraints as a user states them. Each is one entry of a constraint file, in the file's own terms.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <holdfast/constraints/point_tolerance.h>
#include <holdfast/constraints/row_directions.h>
#include <holdfast/constraints/selection.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

class GuideSurface;

/// Every selected vertex stays where it is at rest, and the surface does not rotate there: q = 0.
struct FixedConstraint {
  static constexpr const char* kType = "fixed";
  Selection select;
};

/// A rotation by `degrees` about the line through `center` along `axis`. `degrees` is any number. `axis` is not zero
/// and has any length.
struct AxisRotation {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0;
  std::optional<Vector3> center;  ///< where absent, the centroid of the selected vertices at rest
};

/// A rotation by `degrees` about `axis`. `degrees` is any number. `axis` is not zero and has any length.
struct AxisAngle {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0;
};

/// The handle rotates as it moves about the fixed vertices. At rest its centroid lies in one direction from the
/// centroid of the fixed vertices. After `HandleConstraint::translate` it lies in another direction from there. The
/// handle makes the shortest rotation that takes the first direction to the second, about its own centroid.
struct RotationAboutFixed {
  /// Angles that differ by whole turns make the same rotation. The one that is nearest to this is meant; without this,
  /// the shortest. Where the two directions are opposite, the axis is the one across them that is nearest to this one.
  std::optional<AxisAngle> near;
};

/// A right-handed frame in space. Its y is made perpendicular to x, and its z is across both. `x` and `y` are neither
/// zero nor parallel. Their lengths do not matter.
struct Frame {
  std::optional<Vector3> origin;
  Vector3 x = Vector3::UnitX();
  Vector3 y = Vector3::UnitY();
};

/// The rigid motion that takes `from` to `to`. It rotates by the shortest rotation, and by `turns` whole turns more
/// about the same axis.
struct FrameMotion {
  Frame from;       ///< without an origin, that is the centroid of the selected vertices at rest
  Frame to;         ///< without an origin, that is the origin of `from`
  Index turns = 0;  ///< not 0 only where the rotation has an axis
};

/// Each vertex goes to a place of its own. There are three places or more, in the order of the selection. The selection
/// has to be distinct `VertexIds`. The rotation of the handle is the one that fits the places best.
struct VertexTargets {
  std::vector<Vector3> places;
};

/// Every selected vertex goes where `motion` takes it, and from there by `translate`. Without a motion it only goes by
/// `translate`. The rotation of the motion is handed on to the surface; without a motion there is none. A scale is not
/// handed on: the surface around keeps the size of its detail.
struct HandleConstraint {
  static constexpr const char* kType = "handle";
  Selection select;
  std::variant<std::monostate, AxisRotation, RotationAboutFixed, FrameMotion, VertexTargets> motion;
  Vector3 translate = Vector3::Zero();
  /// Each vertex hands its own rotation on to the surface in place of that of the motion. The list has one rotation for
  /// each id, and the selection has to be distinct `VertexIds`; or the list is empty.
  std::vector<AxisAngle> rotations;
  /// The handle is scaled by these factors before it moves, each above 0. It is scaled about the point about which it
  /// rotates, else about its centroid, along the axes of `FrameMotion::from`, else along those of coordinates.
  Vector3 scale = Vector3::Ones();
};

/// A point goes to a place, in model units.
struct Target {
  Vector3 place = Vector3::Zero();

  [[nodiscard]] Vector3 placeFrom(const Vector3& /*rest*/) const { return place; }
  [[nodiscard]] Vector3 shiftFrom(const Vector3& rest) const { return place - rest; }
  [[nodiscard]] static RowDirections directions() { return {}; }
};

/// A point goes by a shift from where it is at rest, in model units.
struct Move {
  Vector3 shift = Vector3::Zero();

  [[nodiscard]] Vector3 placeFrom(const Vector3& rest) const { return rest + shift; }
  [[nodiscard]] Vector3 shiftFrom(const Vector3& /*rest*/) const { return shift; }
  [[nodiscard]] static RowDirections directions() { return {}; }
};

/// A point keeps to one or two coordinates, in model units, and is free to move along the others.
struct Coordinates {
  std::array<std::optional<double>, 3> values;

  /// The place that is nearest to `rest`.
  [[nodiscard]] Vector3 placeFrom(const Vector3& rest) const;
  [[nodiscard]] Vector3 shiftFrom(const Vector3& rest) const { return placeFrom(rest) - rest; }
  [[nodiscard]] RowDirections directions() const;
};

/// A point stays on a plane, and is free to move in it.
struct OnPlane {
  std::optional<Vector3> point;       ///< of the plane; where absent, the place of the constrained point at rest
  Vector3 normal = Vector3::UnitZ();  ///< not zero, of any length
  double offset = 0;                  ///< by how far the plane lies from there along the normal, model units

  /// The place that is nearest to `rest`. On planes and lines along coordinate axes it has the coordinates of `point`
  /// to the last bit.
  [[nodiscard]] Vector3 placeFrom(const Vector3& rest) const;
  [[nodiscard]] Vector3 shiftFrom(const Vector3& rest) const;
  [[nodiscard]] RowDirections directions() const { return RowDirections::along(normal); }
};

/// A point stays on a line, and is free to move along it.
struct OnLine {
  std::optional<Vector3> point;          ///< of the line; where absent, the place of the constrained point at rest
  Vector3 direction = Vector3::UnitZ();  ///< not zero, of any length

  /// The place that is nearest to `rest`. On planes and lines along coordinate axes it has the coordinates of `point`
  /// to the last bit.
  [[nodiscard]] Vector3 placeFrom(const Vector3& rest) const;
  [[nodiscard]] Vector3 shiftFrom(const Vector3& rest) const;
  [[nodiscard]] RowDirections directions() const { return RowDirections::across(direction); }
};

/// A point lies on a surface beside the mesh, and is free to move along it.
struct OnMesh {
  std::string path;                                  ///< of the file that it was read from, or any name
  std::shared_ptr<const GuideSurface> surface = {};  ///< null where the file was not read

  /// The foot of `rest`, with which the search for the place of the least energy begins.
  [[nodiscard]] Vector3 placeFrom(const Vector3& rest) const;
  [[nodiscard]] Vector3 shiftFrom(const Vector3& rest) const { return placeFrom(rest) - rest; }
  /// Along one direction, as on a plane: the normal of the surface, which is another one everywhere, and along none of
  /// the coordinate axes.
  [[nodiscard]] static RowDirections directions() { return RowDirections::along(Vector3::Ones()); }
};

/// Returns where a place of the surface is at rest.
using RestPlace = std::function<Vector3(const SurfaceLocation&)>;

/// One point of the surface goes to one place, or stays on a plane, a line or another surface.
struct PointConstraint {
  static constexpr const char* kType = "point";
  SurfaceLocation at;
  std::variant<Target, Move, Coordinates, OnPlane, OnLine, OnMesh> to;
  PointTolerance within = {};  ///< how near it comes to where it goes

  [[nodiscard]] std::vector<SurfaceLocation> places() const { return {at}; }
  /// Tells whether the point goes to one place.
  [[nodiscard]] bool hasTarget() const { return directions().areAll(); }
  /// Returns the directions in which the point is not free.
  [[nodiscard]] RowDirections directions() const
  {
    return std::visit([](const auto& its) { return its.directions(); }, to);
  }
  /// The point goes from where it is at rest to `place`, to the last bit. A shift stays a shift unless no shift does
  /// so; then it becomes a target. A point that is free in some directions moves its plane or line there, or takes the
  /// coordinates that it prescribes.
  void setTarget(const Vector3& place, const RestPlace& restPlace);
};

/// Returns where the point goes if it is at `rest` before, bit for bit as the solver takes it. That is the nearest
/// place where it is free in some directions.
[[nodiscard]] inline Vector3 placeOf(const PointConstraint& point, const Vector3& rest)
{
  return std::visit([&](const auto& to) { return to.placeFrom(rest); }, point.to);
}

/// Returns by how much the point moves if it is at `rest` before, bit for bit as the solver takes it.
[[nodiscard]] inline Vector3 shiftOf(const PointConstraint& point, const Vector3& rest)
{
  return std::visit([&](const auto& to) { return to.shiftFrom(rest); }, point.to);
}

/// The selected vertices move as one body. The vectors between them are kept but for its rotation, and the rotations of
/// all of them are equal, equations (28) and (29).
struct RigidConstraint {
  static constexpr const char* kType = "rigid";
  Selection select;
};

/// The plane that lies nearest to the selected vertices at rest, by least squares.
struct FittedPlane {
  /// Along a direction that the vertices tell.
  [[nodiscard]] static RowDirections directions() { return RowDirections::along(Vector3::Ones()); }
};

/// The line that lies nearest to the selected vertices at rest, by least squares.
struct FittedLine {
  /// Across a direction that the vertices tell.
  [[nodiscard]] static RowDirections directions() { return RowDirections::across(Vector3::Ones()); }
};

/// Every selected vertex stays on a plane, a line or another surface, and is free to move along it. Where a plane or a
/// line names no point, each vertex has one of its own, through its place at rest.
struct SlideConstraint {
  static constexpr const char* kType = "slide";
  Selection select;
  std::variant<OnPlane, OnLine, FittedPlane, FittedLine, OnMesh> on;
  /// The plane or the line itself may shift, but does not turn: what the vertices have of it is kept between them.
  bool together = false;
  PointTolerance within = {};  ///< how near each vertex comes; not where they shift together

  /// Returns the directions in which the vertices are not free.
  [[nodiscard]] RowDirections directions() const
  {
    return std::visit([](const auto& its) { return its.directions(); }, on);
  }
};

/// Two points of the surface come together. They may be of two parts.
struct CoincidentConstraint {
  static constexpr const char* kType = "coincident";
  SurfaceLocation from;
  SurfaceLocation to;

  [[nodiscard]] std::vector<SurfaceLocation> places() const { return {from, to}; }
  [[nodiscard]] bool hasTarget() const { return false; }
  void setTarget(const Vector3& /*target*/, const RestPlace& /*restPlace*/) {}
};

/// The vector p_from - p_to is prescribed, Fig. 8. It is `offset`, in model units; where that is absent it is the
/// vector at rest, rotated as the surface rotates.
struct RelativeConstraint {
  static constexpr const char* kType = "relative";
  SurfaceLocation from;
  SurfaceLocation to;
  std::optional<Vector3> offset;

  [[nodiscard]] std::vector<SurfaceLocation> places() const { return {from, to}; }
  [[nodiscard]] bool hasTarget() const { return offset.has_value(); }
  void setTarget(const Vector3& vector, const RestPlace& /*restPlace*/) { offset = vector; }
};

/// The surface is its own mirror image across a plane. Each vertex on one side has a partner on the other, whose image
/// it is, and vertices on the plane stay on it. Partners are found where the surface is symmetric at rest, or are
/// listed. Rotations that constraints give to a vertex are handed on to its partner, mirrored, and so are rigid
/// regions.
struct MirrorConstraint {
  static constexpr const char* kType = "mirror";
  Vector3 point = Vector3::Zero();    ///< of the plane
  Vector3 normal = Vector3::UnitX();  ///< not zero, of any length
  /// How far a vertex may be from the image of its partner at rest, model units. Where this is absent it is
  /// `kMirrorTolerance` of the diagonal.
  std::optional<double> tolerance;
  Selection select = {AllOf{}};  ///< the vertices that get partners; all unless it says otherwise
  std::vector<std::array<Index, 2>>
      pairs;  ///< two vertices each, or one on the plane twice; where none, they are found
};

/// Something that a file says of a constraint, such as a column of a point list. It means nothing to the solution.
struct ExtraText {
  std::string title;  ///< not empty
  std::string text;

  friend bool operator==(const ExtraText&, const ExtraText&) = default;
};

/// One entry of a constraint file.
struct Constraint {
  std::string name;  ///< no other constraint of the list has it
  bool isEnabled = true;
  std::variant<FixedConstraint, HandleConstraint, PointConstraint, RigidConstraint, RelativeConstraint, SlideConstraint,
               CoincidentConstraint, MirrorConstraint>
      what;
  std::vector<ExtraText> extra = {};  ///< kept for files that are written from it; no title repeats
};

/// Returns the name of the constraint's type in files and reports: "fixed", "handle", ...
[[nodiscard]] inline const char* typeName(const Constraint& constraint)
{
  return std::visit([](const auto& what) { return what.kType; }, constraint.what);
}

/// Returns the selection of a constraint that has one, and null for others.
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

/// Returns the surface beside the mesh that a constraint is on, and null for others.
[[nodiscard]] OnMesh* guideMeshOf(Constraint& constraint);

/// Returns the places of the surface that a constraint names, in the order of the keys of files. Those that have a
/// selection name none.
[[nodiscard]] std::vector<SurfaceLocation> placesOf(const Constraint& constraint);

/// Tells whether a constraint has one target of its own: the place of a point, or the offset of a vector.
[[nodiscard]] bool hasTarget(const Constraint& constraint);

/// Gives a constraint that has a target another one, in model units. Does nothing to others. Throws what `restPlace`
/// throws.
void setTarget(Constraint& constraint, const Vector3& target, const RestPlace& restPlace);

/// A whole constraint file. The order of the constraints is their precedence: where not all can hold, the earlier ones
/// do.
///
///     ConstraintList list;
///     list.constraints.push_back({"base", true, FixedConstraint{{InBox{{-60, -40, -1}, {60, 40, 2}}}}});
///     list.constraints.push_back({"P1", true, PointConstraint{AtNear{{0, 23, 65}}, Target{{0.4, 22.6, 65.4}}}});
///     HandleConstraint tip;
///     tip.select.what = VertexIds{{10, 11, 12}};
///     tip.motion = AxisRotation{Vector3::UnitZ(), 90, {}};
///     list.constraints.push_back({"tip", true, tip});
struct ConstraintList {
  std::string units;  ///< the user's name of the unit of length ("mm"); may be empty
  std::vector<Constraint> constraints;
};

}  // namespace holdfast
