#include "support/constraint_systems.h"

namespace holdfast::test {

ConstraintSystem systemOf(const Mesh& mesh, const ConstraintList& list)
{
  const Triangulation triangulation = triangulate(mesh);
  return makeConstraintSystem(list, mesh, makeSolverMesh(mesh, triangulation), SurfaceLocator(mesh, triangulation),
                              "list");
}

}  // namespace holdfast::test
