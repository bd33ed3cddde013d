#pragma once
/// This function makes mirrored copies of constraints.

#include <memory>
#include <vector>

#include <holdfast/constraints/constraint.h>
#include <holdfast/deform/model.h>

namespace holdfast {

/// Holds a place of the plane, and its normal of unit length.
struct MirrorPlane {
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::UnitX();
};

/// Returns the constraints at `indices` as a mirror shows them: they do beyond the plane what these do on their side.
/// Points of the surface become those closest to the mirrored places. Vertices by id, parts, and boxes that the plane
/// does not leave upright become vertices by id. They are the vertices that a mirror would show nearest to one of those
/// selected. Throws `InputError` with the name of a constraint that does not fit the mesh or has nothing beyond the
/// plane. Throws it too for a constraint whose single vertices have no counterparts that differ. O(N + k log T) for a
/// region by id of about k vertices.
[[nodiscard]] ConstraintList mirrored(const ConstraintList& list, const std::vector<Index>& indices,
                                      const MirrorPlane& plane, const Model& model);

}  // namespace holdfast
