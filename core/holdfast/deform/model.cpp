#include "holdfast/deform/model.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <holdfast/base/error.h>

namespace holdfast {

Model makeModel(Mesh mesh, const std::string& source)
{
  if (mesh.faces.isEmpty()) throw InputError({source, 0, ""}, "the mesh has no faces; give a surface mesh");
  if (const std::vector<Finding> broken = findNonFinite(mesh); !broken.empty())
    throw InputError({source, 0, fmt::format("vertex {}", broken.front().ids.front())}, broken.front().message);
  Model model;
  model.mesh = std::move(mesh);
  model.triangulation = triangulate(model.mesh);
  model.solverMesh = makeSolverMesh(model.mesh, model.triangulation);
  if (!std::isfinite(model.solverMesh.diagonal))
    throw InputError({source, 0, ""}, "the mesh is larger than a double can say; scale it down");
  if (!(model.solverMesh.diagonal > 0))
    throw InputError({source, 0, ""}, "all vertices lie in one place; the mesh has no size to deform");
  model.findings = checkMesh(model.mesh, model.triangulation, model.solverMesh);
  return model;
}

std::vector<Triangle> trianglesOverUnknowns(const Model& model)
{
  std::vector<Triangle> triangles = model.triangulation.triangles;
  for (Triangle& triangle : triangles)
    for (Index& vertex : triangle) vertex = model.solverMesh.weld.unknownOf[vertex];
  return triangles;
}

}  // namespace holdfast
