#include "holdfast/geometry/bounding_box.h"

namespace holdfast {

Eigen::AlignedBox3d boundingBox(const Positions& positions)
{
  if (positions.rows() == 0) return {};
  return {Vector3(positions.colwise().minCoeff()), Vector3(positions.colwise().maxCoeff())};
}

double boundingBoxDiagonal(const Positions& positions)
{
  return positions.rows() == 0 ? 0.0 : boundingBox(positions).diagonal().stableNorm();
}

}  // namespace holdfast
