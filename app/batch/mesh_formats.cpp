#include "batch/mesh_formats.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include <holdfast/io/mesh_file.h>

#include "batch/options.h"

namespace holdfast::batch {
namespace {

std::string extensionOf(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

std::string knownFormats()
{
  std::string text;
  for (const std::string_view extension : meshExtensions())
    text += fmt::format("{}{}", text.empty() ? "" : ", ", extension);
  return text;
}

void requireMeshExtension(const std::filesystem::path& path)
{
  const auto known = meshExtensions();
  if (std::find(known.begin(), known.end(), extensionOf(path)) == known.end())
    throw UsageError(fmt::format("--out: \"{}\" has none of the extensions {}", path.string(), knownFormats()));
}

void requireFieldsExtension(const std::filesystem::path& path)
{
  if (extensionOf(path) != ".vtp")
    throw UsageError(fmt::format("--fields: \"{}\" does not end in .vtp", path.string()));
}

MeshDocument readAnyMesh(const std::filesystem::path& path)
{
  return readMesh(path);
}

Serialized serializeAnyMesh(const MeshDocument& document, const Positions& positions, const std::filesystem::path& path)
{
  return serializeMesh(document, positions, extensionOf(path));
}

Positions storedPositions(const Positions& positions, const std::filesystem::path& path)
{
  if (extensionOf(path) != ".stl") return positions;
  return positions.cast<float>().cast<double>();
}

}  // namespace holdfast::batch
