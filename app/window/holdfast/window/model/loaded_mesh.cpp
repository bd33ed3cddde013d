#include "holdfast/window/model/loaded_mesh.h"

#include <utility>

#include <fmt/format.h>

#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/files/any_mesh_file.h>
#include <holdfast/widgets/mesh/coarse_surface.h>

namespace holdfast {

LoadedMesh loadMesh(const std::filesystem::path& path, Progress& progress)
{
  progress.step(fmt::format("reading {}", path.filename().string()));
  return prepareMesh(readAnyMesh(path), path, progress);
}

LoadedMesh prepareMesh(MeshDocument document, const std::filesystem::path& path, Progress& progress)
{
  progress.step(fmt::format("preparing {} vertices", document.mesh.vertexCount()));
  LoadedMesh loaded;
  loaded.path = path;
  loaded.document = std::move(document);
  loaded.model = std::make_shared<const Model>(makeModel(loaded.document.mesh, path.string()));
  const Model& model = *loaded.model;
  loaded.selector = std::make_shared<Selector>(model.mesh, model.solverMesh, model.locator());
  loaded.regions = std::make_shared<VertexRegions>(model.mesh, model.solverMesh);
  loaded.contents = std::make_shared<SceneContents>(model);
  if (isLarge(model)) loaded.contents->setDetail(Detail::Coarse);
  loaded.surface = std::make_shared<const VisibleSurface>(model);
  return loaded;
}

bool isLarge(const Model& model)
{
  return static_cast<Index>(model.triangulation.triangles.size()) > 2 * kCoarseTriangles;
}

}  // namespace holdfast
