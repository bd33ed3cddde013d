#include "holdfast/widgets/files/any_mesh_file.h"

#include <holdfast/base/error.h>
#include <holdfast/base/lower_case.h>
#include <holdfast/base/printable.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/mesh/stated_places.h>
#include <holdfast/widgets/files/poly_data_file.h>

namespace holdfast {

namespace {

/// Polygons of VTK have three corners or more.
Serialized serializeByVtk(const MeshDocument& document, const Positions& positions, const std::string& extension)
{
  Serialized result = serializePolyData(document, positions, extension);
  const auto leftOut = static_cast<Index>(facesWithoutSurface(document.mesh.faces).size());
  if (leftOut > 0) result.notes.push_back(counted(leftOut, "face") + " of fewer than three corners left behind");
  return result;
}

}  // namespace

std::vector<std::string_view> anyMeshExtensions()
{
  const auto core = meshExtensions();
  std::vector<std::string_view> all(core.begin(), core.end());
  all.emplace_back(".vtp");
  return all;
}

std::vector<std::string_view> anyOutputExtensions()
{
  std::vector<std::string_view> all = anyMeshExtensions();
  all.emplace_back(".vtk");
  return all;
}

MeshDocument readAnyMesh(const std::filesystem::path& path)
{
  const std::string extension = lowerCase(path.extension().string());
  if (extension == ".vtk")
    throw InputError({path.string(), 0, ""},
                     "legacy VTK files (.vtk) are not read: save it as .vtp, for example in ParaView (Save Data)");
  return extension == ".vtp" ? readPolyData(path) : readMesh(path, anyMeshExtensions());
}

Serialized serializeAnyMesh(const MeshDocument& document, const Positions& positions, const std::filesystem::path& path)
{
  const std::string extension = lowerCase(path.extension().string());
  const bool isVtks = extension == ".vtp" || extension == ".vtk";
  try {
    if (!isVtks) return serializeMesh(document, positions, extension);
    return serializeByVtk(document, withStatedPlaces(document.mesh.positions, positions), extension);
  } catch (const OutputError& error) {
    throw OutputError(path.string(), error.reason());
  }
}

}  // namespace holdfast
