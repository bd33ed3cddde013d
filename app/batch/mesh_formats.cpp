#include "batch/mesh_formats.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include <holdfast/base/error.h>
#include <holdfast/base/printable.h>
#include <holdfast/io/mesh_file.h>
#ifdef HOLDFAST_WITH_VTK
#include <holdfast/widgets/files/field_file.h>
#endif

#include "batch/options.h"

namespace holdfast::batch {
namespace {

std::vector<std::string_view> knownExtensions()
{
#ifdef HOLDFAST_WITH_VTK
  return anyMeshExtensions();
#else
  const auto core = meshExtensions();
  return {core.begin(), core.end()};
#endif
}

}  // namespace

std::string extensionOf(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string knownFormats()
{
  std::string text;
  for (const std::string_view extension : knownExtensions())
    text += fmt::format("{}{}", text.empty() ? "" : ", ", extension);
  return text;
}

void requireMeshExtension(const std::filesystem::path& path)
{
  const auto known = knownExtensions();
  if (std::find(known.begin(), known.end(), extensionOf(path)) == known.end())
    throw UsageError(
        fmt::format("--out: \"{}\" has none of the extensions {}", printable(path.string()), knownFormats()));
}

void requireFieldsExtension(const std::filesystem::path& path)
{
#ifndef HOLDFAST_WITH_VTK
  throw UsageError("--fields: this build has no VTK to write \"" + path.string() + "\" with; leave the option out");
#endif
  if (extensionOf(path) != ".vtp")
    throw UsageError(fmt::format("--fields: \"{}\" does not end in .vtp", printable(path.string())));
}

#ifdef HOLDFAST_WITH_VTK

Serialized serializeFields(const Mesh& mesh, const Positions& positions, std::span<const Field> fields)
{
  return fieldsToVtp(mesh, positions, fields, {});
}

#else

MeshDocument readAnyMesh(const std::filesystem::path& path)
{
  return readMesh(path);
}

Serialized serializeAnyMesh(const MeshDocument& document, const Positions& positions, const std::filesystem::path& path)
{
  try {
    return serializeMesh(document, positions, extensionOf(path));
  } catch (const OutputError& error) {
    throw OutputError(path.string(), error.reason());
  }
}

Serialized serializeFields(const Mesh& /*mesh*/, const Positions& /*positions*/, std::span<const Field> /*fields*/)
{
  throw std::logic_error("fields were asked for in a build without VTK");
}

#endif

}  // namespace holdfast::batch
