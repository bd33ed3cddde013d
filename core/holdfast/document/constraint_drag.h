#pragma once
/// Points and handles that the user drags together.

#include <optional>
#include <span>
#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/constraints/handle_drag.h>
#include <holdfast/deform/model.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// One gesture on some constraints of a list, each motion measured from where it began. Handles that turn about what is
/// fixed follow it from frame to frame (`followed`); but for these no motion is exactly the list that there was.
class ConstraintDrag {
 public:
  /// Enabled points and handles among `constraints` (places in the list) move. Throws `InputError` where one does not
  /// fit the mesh; `source` names the list. `model` stays alive as long as this.
  ConstraintDrag(const Model& model, const ConstraintList& list, std::span<const Index> constraints,
                 const std::string& source);

  [[nodiscard]] bool isEmpty() const noexcept { return points_.empty() && handles_.empty(); }
  [[nodiscard]] bool hasHandles() const noexcept { return !handles_.empty(); }
  /// A handle, or several points as a group.
  [[nodiscard]] bool canRotate() const noexcept { return hasHandles() || points_.size() > 1; }

  /// The middle of where all that moves is to be, model units. Something moves.
  [[nodiscard]] Vector3 center() const;

  /// Axes of the first constraint that moves, right-handed orthonormal columns. Of a handle: the axes of the frame that
  /// it goes to, else its `principalAxes` at rest, turned with it. Of a point: its `surfaceAxes` at `positions`.
  [[nodiscard]] Eigen::Matrix3d axes(const Positions& positions) const;

  /// The centroid of all that is fixed; none where nothing is or no handle moves.
  [[nodiscard]] std::optional<Vector3> fixedCenter() const
  {
    return handles_.empty() ? std::nullopt : handles_.front().setting.surroundings.fixedCenter;
  }

  /// The list after the motion, the next frame of the gesture.
  [[nodiscard]] ConstraintList movedBy(const RigidIncrement& increment);

  /// Vertices of the file that handles move, and where `moved`, a list that `movedBy` gave, takes them: one row for
  /// each. Throws as `placeHandle`. O(vertices).
  [[nodiscard]] std::vector<Index> handleVertices() const;
  [[nodiscard]] Positions handlePlaces(const ConstraintList& moved) const;

 private:
  struct DraggedPoint {
    Index constraint = 0;
    SurfacePoint point;
    Vector3 rest;
    Vector3 place;  // where it is to be
  };
  struct DraggedHandle {
    Index constraint = 0;
    HandleSetting setting;
    Vector3 center;  // of where it is to be
    AxisAngle turn;  // of the last frame
  };

  [[nodiscard]] const HandleConstraint& startOf(const DraggedHandle& dragged) const;
  [[nodiscard]] HandleConstraint nextFrame(DraggedHandle& dragged, const RigidIncrement& increment) const;

  const Model* model_;
  ConstraintList list_;
  std::vector<DraggedPoint> points_;
  std::vector<DraggedHandle> handles_;
};

/// Points of one place of the surface.
struct SharedPlace {
  std::vector<Index> constraints;  ///< their places in the list, ascending; two or more
  Vector3 mean = Vector3::Zero();  ///< of where they go: a target on which all of them can agree
};

/// All points of `system` that are where `constraints` are. Nothing unless those are points of one place, two or more.
/// O(rows).
[[nodiscard]] std::optional<SharedPlace> sharedPlace(const ConstraintSystem& system,
                                                     std::span<const Index> constraints);

}  // namespace holdfast
