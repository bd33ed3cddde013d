#include <fmt/format.h>

#include <holdfast/view/any_mesh_file.h>
#include <holdfast/widgets/loaded_mesh.h>

namespace holdfast {

LoadedMesh loadMesh(const std::filesystem::path& path, Progress& progress)
{
  LoadedMesh loaded;
  loaded.path = path;
  progress.stage(fmt::format("reading {}", path.filename().string()));
  loaded.document = readAnyMesh(path);
  progress.stage(fmt::format("preparing {} vertices", loaded.document.mesh.vertexCount()));
  loaded.model = std::make_shared<const Model>(makeModel(loaded.document.mesh, path.string()));
  loaded.shaded = std::make_shared<const ShadedSurface>(cutAtSharpEdges(*loaded.model));
  loaded.regions = std::make_shared<VertexRegions>(loaded.model->mesh, loaded.model->solverMesh);
  return loaded;
}

}  // namespace holdfast
