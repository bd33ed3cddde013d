#include "holdfast/geometry/centroid.h"

#include <cassert>

namespace holdfast {

Vector3 centroid(const Positions& points)
{
  assert(points.rows() > 0);
  return points.colwise().mean().transpose();
}

}  // namespace holdfast
