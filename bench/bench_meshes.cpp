#include "bench/bench_meshes.h"

#include <filesystem>

#include <holdfast/io/mesh_file.h>

#include "bench/bumpy_mesh.h"

namespace holdfast::bench {
namespace {

BenchMesh generated(Index thousands, Index divisions)
{
  const std::string name = "bumpy " + std::to_string(thousands) + "k";
  return {name, thousands, [divisions, name] { return makeModel(bumpyMesh(divisions), name); }};
}

BenchMesh middle()
{
  return generated(173, 170);
}

void addFromLibrary(std::vector<BenchMesh>& meshes, const std::string& name, Index thousands, const std::string& file)
{
  const std::filesystem::path path = std::filesystem::path(HOLDFAST_MESH_LIBRARY) / "real" / file;
  if (std::filesystem::exists(path))
    meshes.push_back({name, thousands, [path] { return makeModel(readMesh(path).mesh, path.string()); }});
}

}  // namespace

std::vector<BenchMesh> benchMeshes()
{
  std::vector<BenchMesh> meshes{generated(35, 76), middle(), generated(438, 270)};
  addFromLibrary(meshes, "bunny 35k", 35, "bunny_35k.ply");
  addFromLibrary(meshes, "armadillo 173k", 173, "armadillo_173k.ply");
  addFromLibrary(meshes, "dragon 438k", 438, "dragon_438k.ply");
  return meshes;
}

std::vector<BenchMesh> benchMeshesUpTo(Index thousands)
{
  std::vector<BenchMesh> meshes = benchMeshes();
  std::erase_if(meshes, [thousands](const BenchMesh& mesh) { return mesh.thousands > thousands; });
  return meshes;
}

Model middleModel()
{
  return middle().load();
}

}  // namespace holdfast::bench
