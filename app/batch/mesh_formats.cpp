#include "batch/mesh_formats.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <fmt/ranges.h>

#include <holdfast/base/error.h>
#include <holdfast/base/lower_case.h>
#include <holdfast/base/printable.h>
#include <holdfast/io/mesh_file.h>
#ifdef HOLDFAST_WITH_VTK
#include <holdfast/widgets/files/any_mesh_file.h>
#include <holdfast/widgets/files/poly_data_file.h>
#endif

#include "batch/options.h"

namespace holdfast::batch {
namespace {

#ifndef HOLDFAST_WITH_VTK
std::vector<std::string_view> anyMeshExtensions()
{
  const auto core = meshExtensions();
  return {core.begin(), core.end()};
}

std::vector<std::string_view> anyOutputExtensions()
{
  return anyMeshExtensions();
}
#endif

}  // namespace

std::string extensionOf(const std::filesystem::path& path)
{
  return lowerCase(path.extension().string());
}

std::string knownFormats()
{
  return fmt::format("{}", fmt::join(anyMeshExtensions(), ", "));
}

void requireMeshExtension(const std::filesystem::path& path)
{
  const auto known = anyOutputExtensions();
  if (std::find(known.begin(), known.end(), extensionOf(path)) == known.end())
    throw UsageError(
        fmt::format("--out: \"{}\" has none of the extensions {}", printable(path.string()), fmt::join(known, ", ")));
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
