#pragma once
/// What a deformation looks like as numbers over the vertices of the file.

#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/mesh/field.h>

namespace holdfast {

/// In the order in which they are written to files.
enum class FieldKind {
  ConstraintResidual,  ///< model units; the largest of the constraints that hang on the vertex, NaN where there is none
  ConstraintStatus,    ///< 0 none, 1 met, 2 redundant, 3 conflicting, 4 missed; the gravest at the vertex
  Displacement,        ///< three components, model units
  RotationLog,         ///< three components: half angle times axis, radians
  RotationAngleDegrees,  ///< not wrapped
  ConstraintForce,       ///< `multiplier` of the report, summed; NaN where there is no constraint and for other solvers
  DetailResidual  ///< |L p - R delta|, for `uniform` weights in model units, for the others in one over model units
};

/// The field, called as its kind in small letters: `constraint_residual`. O(N + rows).
[[nodiscard]] Field fieldOf(const Model& model, const DeformResult& deformation, FieldKind kind);

/// All of them. O(N + rows).
[[nodiscard]] std::vector<Field> fieldsOf(const Model& model, const DeformResult& deformation);

}  // namespace holdfast
