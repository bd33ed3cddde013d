#pragma once
/// \file
/// What a deformation looks like as numbers over the vertices of the file.

#include <vector>

#include <holdfast/deform/deform.h>
#include <holdfast/mesh/field.h>

namespace holdfast {

/// `constraint_residual` (model units; the largest of the constraints that hang on the vertex, NaN where there is
/// none), `constraint_status` (0 none, 1 met, 2 redundant, 3 conflicting, 4 missed; the gravest at the vertex),
/// `displacement` (3, model units), `rotation_log` (3, half angle times axis, radians), `rotation_angle_degrees` (not
/// wrapped), `constraint_force` (see `Forces`; NaN where there is no constraint, and but for hard constraints),
/// `detail_residual` (|L p - R delta|, for `uniform` weights in model units, for the
/// others in one over model units). O(N + rows).
[[nodiscard]] std::vector<Field> fieldsOf(const Model& model, const Deformation& deformation);

}  // namespace holdfast
