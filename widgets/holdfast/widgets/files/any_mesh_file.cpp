#include "holdfast/widgets/files/any_mesh_file.h"

#include <algorithm>
#include <cctype>

#include <holdfast/base/error.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/widgets/files/poly_data_file.h>

namespace holdfast {
namespace {

std::string extensionOf(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool isVtkFormat(const std::filesystem::path& path)
{
  const auto vtk = polyDataExtensions();
  return std::find(vtk.begin(), vtk.end(), extensionOf(path)) != vtk.end();
}

}  // namespace

std::vector<std::string_view> anyMeshExtensions()
{
  const auto core = meshExtensions();
  const auto vtk = polyDataExtensions();
  std::vector<std::string_view> all(core.begin(), core.end());
  all.insert(all.end(), vtk.begin(), vtk.end());
  return all;
}

MeshDocument readAnyMesh(const std::filesystem::path& path)
{
  return isVtkFormat(path) ? readPolyData(path) : readMesh(path, anyMeshExtensions());
}

Serialized serializeAnyMesh(const MeshDocument& document, const Positions& positions, const std::filesystem::path& path)
{
  try {
    return isVtkFormat(path) ? serializePolyData(document, positions, extensionOf(path))
                             : serializeMesh(document, positions, extensionOf(path));
  } catch (const OutputError& error) {
    throw OutputError(path.string(), error.reason());
  }
}

}  // namespace holdfast
