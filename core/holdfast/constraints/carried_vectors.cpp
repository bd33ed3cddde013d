#include "holdfast/constraints/carried_vectors.h"

#include <holdfast/geometry/rotation_log.h>

namespace holdfast {

ConstraintSystem turned(ConstraintSystem system, const Columns3& q)
{
  for (const CarriedVector& carried : system.carried) {
    Vector3 mean = Vector3::Zero();
    for (const PointTerm& term : carried.rotation) mean += term.weight * q.row(term.vertex).transpose();
    ConstraintRow& row = system.rows[carried.row];
    row.target = rotationMatrix(mean) * carried.rest;
    row.shift = row.target - carried.rest;
  }
  return system;
}

}  // namespace holdfast
