#include "holdfast/constraints/rotated_vectors.h"

#include <holdfast/geometry/rotation_log.h>

namespace holdfast {

ConstraintSystem rotated(ConstraintSystem system, const Columns3& q)
{
  for (const RotatedVector& rotated : system.rotated) {
    Vector3 mean = Vector3::Zero();
    for (const Term& term : rotated.rotation) mean += term.coefficient * q.row(term.index).transpose();
    ConstraintRow& row = system.rows[rotated.row];
    row.target = rotationMatrix(mean) * rotated.rest;
    row.shift = row.target - rotated.rest;
  }
  return system;
}

}  // namespace holdfast
