#pragma once
/// Fields show a deformation as numbers over the vertices of the file.

#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/mesh/field.h>

namespace holdfast {

/// The fields of a deformation, in the order in which they are written to files.
enum class FieldKind {
  ConstraintResidual,    ///< the largest of the constraints at the vertex, model units; NaN where there are none
  ConstraintStatus,      ///< the gravest at the vertex: 0 none, 1 met, 2 redundant, 3 conflicting, 4 missed
  Displacement,          ///< three components, model units
  RotationLog,           ///< three components: half the angle times the unit axis, radians
  RotationAngleDegrees,  ///< the angle with all its whole turns: it is not wrapped
  /// The length of the sum of the multipliers at the vertex, as `multiplier` of the report. It is NaN where there is no
  /// constraint, and with solvers other than `Hard`.
  ConstraintForce,
  /// |L p - R delta|. With the weights `Uniform` it is in model units, with the others in one over model units.
  DetailResidual
};

/// Makes one field of a deformation of `model`. Its name is that of its kind in small letters: `constraint_residual`.
/// O(N + rows).
///
///     const Field residual = fieldOf(model, result, FieldKind::ConstraintResidual);
///     for (Index v = 0; v < model.mesh.vertexCount(); ++v)
///       if (residual.values[v] > 1e-9) std::cout << "vertex " << v << ": " << residual.values[v] << '\n';
[[nodiscard]] Field fieldOf(const Model& model, const DeformResult& deformation, FieldKind kind);

/// Makes all fields, in the order of `FieldKind`. O(N + rows).
[[nodiscard]] std::vector<Field> fieldsOf(const Model& model, const DeformResult& deformation);

}  // namespace holdfast
