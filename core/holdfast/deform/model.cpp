#include "holdfast/deform/model.h"

#include <cmath>

#include <fmt/format.h>

#include <holdfast/check/mesh_check.h>
#include <holdfast/geometry/bounding_box.h>
#include <holdfast/mesh/labels.h>
#include <holdfast/mesh/stated_places.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {
namespace {

void requireUsableFaces(const Mesh& mesh, const std::string& source)
{
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto fail = [&](const std::string& reason) { throw InputError({source, 0, faceText(mesh, f)}, reason); };
    for (const Index vertex : mesh.faces[f])
      if (vertex < 0 || vertex >= mesh.vertexCount())
        fail(fmt::format("vertex {} does not exist: the mesh has {}, numbered from 0", vertex, mesh.vertexCount()));
  }
}

void requireUsableWeld(const Mesh& mesh, const std::string& source, double tolerance)
{
  const double diagonal = boundingBoxDiagonal(mesh.positions);
  if (tolerance <= kLargestWeld * diagonal || !(diagonal > 0)) return;
  throw InputError({source, 0, ""},
                   fmt::format("vertices cannot be welded within {:.3g}: that is more than {:g} of the diagonal of the "
                               "mesh, {:.4g}; give a smaller tolerance",
                               tolerance, kLargestWeld, diagonal));
}

/// Returns the vertices without a place, which get one: that of a vertex of the surface.
std::vector<Index> givePlaces(Mesh& mesh)
{
  std::vector<Index> withoutPlace = nonFiniteVertices(mesh).unused;
  Index f = 0;
  while (!mesh.faces.isSurface(f)) ++f;
  for (const Index v : withoutPlace) mesh.positions.row(v) = mesh.positions.row(mesh.faces[f].front());
  return withoutPlace;
}

void requireSparseRows(const Model& model, const std::string& source)
{
  const SolverMesh& mesh = model.solverMesh;
  constexpr double kMany = 1000;  // fewer make nothing dense that would be sparse without them
  std::vector<double> count(static_cast<std::size_t>(mesh.unknownCount()), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const Index u : triangle) ++count[u];
  double squares = 0;
  for (const double n : count)
    if (n > kMany) squares += n * n;
  constexpr double kMost = kMostTrianglesAtAVertex;
  if (squares <= kMost * kMost) return;
  const auto largest = std::max_element(count.begin(), count.end());
  throw InputError(
      {source, 0, vertexText(model.mesh, mesh.weld.firstVertexOf[largest - count.begin()])},
      fmt::format("{} triangles meet here, which would fill the memory; divide the faces so that at most {} "
                  "meet at a vertex (of several with more than {}, the root of the sum of squares counts)",
                  *largest, kMostTrianglesAtAVertex, kMany));
}

}  // namespace

SurfaceLocator Model::locator() const
{
  return {mesh, triangulation, surface};
}

Model makeModel(Mesh mesh, const std::string& source, double weldTolerance)
{
  if (static_cast<Index>(facesWithoutSurface(mesh.faces).size()) == mesh.faces.size())
    throw InputError({source, 0, ""}, "the mesh has no faces of three corners or more; give a surface mesh");
  requireUsableFaces(mesh, source);
  if (const std::vector<Finding> broken = findNonFinite(mesh); !broken.empty())
    throw InputError({source, 0, vertexText(mesh, broken.front().ids.front())}, broken.front().message);
  Model model;
  model.surface = std::make_shared<SurfaceIndex>();
  const std::vector<Index> withoutPlace = givePlaces(mesh);
  model.mesh = std::move(mesh);
  model.triangulation = triangulate(model.mesh);
  requireUsableWeld(model.mesh, source, weldTolerance);
  model.solverMesh = makeSolverMesh(model.mesh, model.triangulation, weldTolerance, withoutPlace);
  if (!std::isfinite(model.solverMesh.diagonal))
    throw InputError({source, 0, ""}, "the mesh is too large for doubles; scale it down");
  if (!(model.solverMesh.diagonal > 0))
    throw InputError({source, 0, ""}, "all vertices lie in one place; the mesh has no size to deform");
  requireSparseRows(model, source);
  model.findings = checkMesh(model.mesh, model.triangulation, model.solverMesh);
  return model;
}

Model makeModelOfFile(const MeshDocument& document, const std::string& source, double weldTolerance)
{
  Model model = makeModel(document.mesh, source, weldTolerance);
  for (const std::string& remark : document.remarks) model.findings.push_back({"unusual_file", 1, "file", {}, remark});
  return model;
}

std::vector<Triangle> trianglesOverUnknowns(const Model& model)
{
  std::vector<Triangle> triangles = model.triangulation.triangles;
  for (Triangle& triangle : triangles)
    for (int& vertex : triangle) vertex = model.solverMesh.weld.unknownOf[vertex];
  return triangles;
}

}  // namespace holdfast
