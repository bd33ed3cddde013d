#pragma once
/// The solver sees constraints as the rows of B and d, in the user's order, over unknowns.

#include <memory>
#include <string>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/constraints/known_places.h>
#include <holdfast/constraints/row_directions.h>
#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {

enum class RowKind {
  Position,  ///< where a point of the surface is; its part is taken to be that of its first unknown
  Region,    ///< how an unknown of a rigid region lies to the first one of it: the vector x_i - x_ref of (28)
  Relative,  ///< how one point of the surface lies to another: p_from - p_to, Fig. 8
  Mirrored   ///< how a vertex lies to its partner in a mirror: their sum along the normal, their difference across it
};

/// A row states one equation of B x = d, in the directions in which it holds.
struct ConstraintRow {
  /// Holds the unknowns, ascending, with their coefficients. A pin is one term of weight 1. The coefficients of a
  /// difference sum to 0, those of a mirrored sum to 2. The difference of a point and itself has no terms at all.
  FewTerms terms;
  Vector3 target;        ///< d, model units
  Vector3 shift;         ///< d - B p at rest: what the row asks of the displacement
  Index constraint = 0;  ///< place in the list of the constraint that it came from
  RowKind kind = RowKind::Position;
  /// How many vertices of the file a single point hangs on; 0 for a vertex of a selection. Marks, drags and verdicts
  /// take a position with corners for a point with a target of its own.
  int corners = 0;
  RowDirections directions = {};
  bool isChosen = false;  ///< its target is chosen, see `TolerantRow`: it is eliminated in all directions

  /// Returns the directions in which the row is eliminated.
  [[nodiscard]] RowDirections eliminatedDirections() const { return isChosen ? RowDirections() : directions; }

  /// Tells whether the row is a pin. A pin places a vertex: the solution copies its target.
  [[nodiscard]] bool isPin() const noexcept
  {
    return kind == RowKind::Position && terms.size() == 1 && directions.areAll();
  }
};

/// The target of this row is chosen: of all places that are near enough to `target`, that of the least energy. Where
/// the row holds in some directions alone these are at odds with those of others, and it is chosen along the rest.
struct TolerantRow {
  Index row = 0;  ///< place in `ConstraintSystem::rows`
  PointTolerance within;
  Vector3 target;  ///< as it is stated, model units
  Vector3 shift;   ///< what that asks of the displacement
  /// The point stays on this surface, and `target` is its foot there: at first the foot of the place at rest. Null for
  /// others.
  std::shared_ptr<const GuideSurface> surface = {};
  bool isAtBound = false;  ///< the chosen place lies on a bound, so that the point pulls
};

/// The d of this row turns with the surface. It is exp(q) rest, with q the sum of weight * q_unknown. In a rigid region
/// that is the q of the unknown whose rotation is given first. Where none is given, it is the q of the region's first
/// unknown.
struct RotatedVector {
  Index row = 0;                   ///< place in `ConstraintSystem::rows`
  Vector3 rest = Vector3::Zero();  ///< B p at rest, model units
  std::vector<Term> rotation;      ///< unknowns, ascending, with weights of sum 1
};

/// A constraint prescribes this rotation, q = r.
struct GivenRotation {
  Index unknown = 0;
  Vector3 q = Vector3::Zero();  ///< log: half angle times axis, radians, of any number of turns
  Index constraint = 0;         ///< place in the list
  bool isStated = true;         ///< false for a handle that only moves: 0 is what it does unless rotations are found
};

/// The surface stays flat at this unknown: its rotation is about the normal alone.
struct FlatRotation {
  Index unknown = 0;
  Vector3 normal = Vector3::UnitZ();  ///< of length 1

  friend bool operator==(const FlatRotation&, const FlatRotation&) = default;
};

/// A note says what is doubtful about an enabled constraint that is solved all the same.
struct ConstraintNote {
  Index constraint = 0;  ///< place in the list
  std::string kind;      ///< "unsaid_rotation", "unpaired_vertices", ...
  std::string message;   ///< one sentence for people, without the constraint's name
};

/// More rows whose targets are chosen are refused, because what they ask of one another is a dense matrix, unless all
/// of them are chosen along each coordinate by itself.
inline constexpr std::size_t kMostTolerantPoints = 2000;

/// A handle gets a note if it states no rotation and moves by more than this share of its distance from what is fixed.
inline constexpr double kUnsaidRotation = 0.25;

/// Holds all rows of the enabled constraints, in the user's order. Unknowns are in range, terms are canonical, and
/// numbers are finite.
struct ConstraintSystem {
  std::vector<ConstraintRow> rows;
  std::vector<TolerantRow> tolerant;     ///< ascending by row; until places are chosen the rows have their targets
  std::vector<RotatedVector> rotated;    ///< ascending by row; the rows are as at q = 0, see `rotated`
  std::vector<GivenRotation> rotations;  ///< in the user's order; each unknown once, because the first stands
  std::vector<FlatRotation> flat;        ///< in the user's order; an unknown between flat regions has one of each
  std::vector<std::vector<Index>> rigidRegions;  ///< unknowns of each, ascending; the rows refer to the first
  std::vector<ConstraintNote> notes;             ///< in the user's order
  std::vector<NearPlace> nearPlaces;             ///< of enabled constraints, in the user's order
};

/// Makes the rows of a list of constraints on a mesh of finite positions. `source` names the list in messages. `places`
/// are those of lists before this one on the same mesh. Throws `InputError` with the place in the list for what does
/// not fit the mesh. Throws it too for what `validateHandle` or `placeHandle` refuses.
[[nodiscard]] ConstraintSystem makeConstraintSystem(const ConstraintList& list, const Mesh& mesh,
                                                    const SolverMesh& solverMesh, const SurfaceLocator& locator,
                                                    const std::string& source, KnownPlaces& places);
[[nodiscard]] ConstraintSystem makeConstraintSystem(const ConstraintList& list, const Mesh& mesh,
                                                    const SolverMesh& solverMesh, const SurfaceLocator& locator,
                                                    const std::string& source);

/// Returns `system` as it is where rotations are found. Rotations that are not stated are left out, and so is what is
/// noted of them.
[[nodiscard]] ConstraintSystem withStatedRotations(ConstraintSystem system);

/// Returns `system` with the targets and shifts of its rotated rows at the rotations `q` of all unknowns (n x 3, logs).
/// It counts from rest, whatever rotations the rows had before. Where q is 0 every row is as it was made, bit for bit.
[[nodiscard]] ConstraintSystem rotated(ConstraintSystem system, const Columns3& q);

}  // namespace holdfast
