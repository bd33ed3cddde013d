#pragma once
/// Guides show where constraints leave points free, to scale: planes, lines and mirrors, and the bounds of tolerances.

#include <array>
#include <vector>

#include <holdfast/deform/deform.h>

namespace holdfast {

/// The shape of a guide says what it bounds.
enum class GuideShape {
  Plane,     ///< a rectangle in a plane; it has a faint face as well
  Line,      ///< a part of a line
  Ball,      ///< three circles
  Box,       ///< twelve edges
  Cylinder,  ///< around a line: two circles, joined by four lines
  Distance   ///< joins the two planes of a slab
};

/// A guide is a shape in space that belongs to a constraint.
struct ConstraintGuide {
  Index constraint = 0;  ///< the place of the constraint in the list
  ConstraintStatus status = ConstraintStatus::Met;
  GuideShape shape = GuideShape::Plane;
  Vector3 center = Vector3::Zero();
  /// Its axes are columns. The third one is the normal of a plane, or the direction of a line.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Vector3 half = Vector3::Zero();  ///< how far it reaches along its axes to either side, model units
};

/// Makes the guides of the enabled constraints of a deformation, in their order:
/// - A point on a plane or a line, or one with free coordinates, has a small square or a short line.
/// - Vertices that slide on one plane or one line share one, as large as they lie apart. Where each has its own, some
///   two dozen of them are shown.
/// - A mirror has a rectangle as large as the mesh.
/// - A tolerance has its ball, box, cylinder or slab around the stated target. A weight has none.
///
/// Points on other meshes have bounds alone: the mesh itself is shown. O(rows).
[[nodiscard]] std::vector<ConstraintGuide> constraintGuides(const Model& model, const DeformResult& deformation);

/// Returns the straight lines that draw a guide.
[[nodiscard]] std::vector<std::array<Vector3, 2>> outlineOf(const ConstraintGuide& guide);

/// Returns the corners of a guide of shape `Plane`, one after the other.
[[nodiscard]] std::array<Vector3, 4> cornersOf(const ConstraintGuide& guide);

}  // namespace holdfast
