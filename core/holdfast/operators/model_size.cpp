#include "holdfast/operators/model_size.h"

#include <array>
#include <cmath>

#include <holdfast/geometry/enclosing_sphere.h>

namespace holdfast {

double diameterInDiagonals(const SolverMesh& mesh)
{
  return mesh.diagonal > 0 ? enclosingDiameter(mesh.rest) / mesh.diagonal : 1;
}

double rowsInDiameters(Weights weights, double diameterInDiagonals)
{
  // Rows of the Laplacian have one area below them, the root of one where they are integrated, none where uniform.
  constexpr std::array kLengthsBelow{1, 2, 0};
  return std::pow(diameterInDiagonals, kLengthsBelow[static_cast<std::size_t>(weights)]);
}

}  // namespace holdfast
