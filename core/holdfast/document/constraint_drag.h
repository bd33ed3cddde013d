#pragma once
/// The user drags points and handles together.

#include <optional>
#include <span>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/constraints/handle_drag.h>
#include <holdfast/deform/model.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// A drag is one gesture on some constraints of a list. Each motion is measured from where the gesture began. Handles
/// that turn about what is fixed follow it from frame to frame (`followed`). But for these, no motion gives exactly the
/// list that there was.
class ConstraintDrag {
 public:
  /// Enabled points and handles among `constraints` (places in the list) move, and so do planes and lines on which
  /// points or selections slide, where these are stated. Points on other meshes do not. Throws `InputError` where one
  /// does not fit the mesh. `source` names the list. `model` must stay alive as long as the drag.
  ConstraintDrag(const Model& model, const ConstraintList& list, std::span<const Index> constraints,
                 const std::string& source);

  [[nodiscard]] bool isEmpty() const noexcept { return count() == 0; }
  [[nodiscard]] bool hasHandles() const noexcept { return !handles_.empty(); }
  /// Tells whether what moves can turn: a handle can, and so can several points as a group.
  [[nodiscard]] bool canRotate() const noexcept { return hasHandles() || count() > 1; }
  /// Returns the directions in which a motion changes anything: a plane moves along its normal, a line across itself.
  [[nodiscard]] RowDirections directions() const;

  /// Returns the middle of where all that moves is to be, in model units. Something must move.
  [[nodiscard]] Vector3 center() const;

  /// Returns the axes of the first constraint that moves, as right-handed orthonormal columns. A handle has the axes of
  /// the frame that it goes to. Without a frame it has its `principalAxes` at rest, turned with it. A point has its
  /// `surfaceAxes` at `positions`. Where motions change nothing in some `directions`, the third axis is that of these.
  [[nodiscard]] Eigen::Matrix3d axes(const Positions& positions) const;

  /// Returns the centroid of all that is fixed. Returns none where nothing is fixed or no handle moves.
  [[nodiscard]] std::optional<Vector3> fixedCenter() const
  {
    return handles_.empty() ? std::nullopt : handles_.front().setting.surroundings.fixedCenter;
  }

  /// Returns the list after the motion, the next frame of the gesture.
  [[nodiscard]] ConstraintList movedBy(const RigidIncrement& increment);

  /// Returns the vertices of the file that handles move. O(vertices).
  [[nodiscard]] std::vector<Index> handleVertices() const;
  /// Returns where `moved` takes those vertices, one row for each. `moved` is a list that `movedBy` gave. Throws as
  /// `placeHandle` does. O(vertices).
  [[nodiscard]] Positions handlePlaces(const ConstraintList& moved) const;

 private:
  struct DraggedPoint {
    Index constraint = 0;
    SurfacePoint point;
    Vector3 rest;
    Vector3 place;  // where it is to be
    RowDirections directions;
  };
  struct DraggedHandle {
    Index constraint = 0;
    HandleSetting setting;
    Vector3 center;  // of where it is to be
    AxisAngle turn;  // of the last frame
  };

  /// The plane or line on which a selection slides.
  struct DraggedGuide {
    Index constraint = 0;
    Vector3 place;  // the nearest on it to the centroid of the selection
    RowDirections directions;
  };

  [[nodiscard]] std::size_t count() const noexcept { return points_.size() + handles_.size() + guides_.size(); }
  [[nodiscard]] const HandleConstraint& startOf(const DraggedHandle& dragged) const;
  [[nodiscard]] HandleConstraint nextFrame(DraggedHandle& dragged, const RigidIncrement& increment) const;

  const Model* model_;
  ConstraintList list_;
  std::vector<DraggedPoint> points_;
  std::vector<DraggedHandle> handles_;
  std::vector<DraggedGuide> guides_;
};

/// These points of the list lie at one place of the surface.
struct SharedPlace {
  std::vector<Index> constraints;  ///< their places in the list, ascending; two or more
  Vector3 mean = Vector3::Zero();  ///< of where they go: a target on which all of them can agree
};

/// Returns all points of `system` that are where `constraints` are. Returns nothing unless those are two or more points
/// of one place. O(rows).
[[nodiscard]] std::optional<SharedPlace> sharedPlace(const ConstraintSystem& system,
                                                     std::span<const Index> constraints);

}  // namespace holdfast
