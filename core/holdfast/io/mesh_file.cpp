#include "holdfast/io/mesh_file.h"

#include <fmt/ranges.h>

#include <holdfast/base/error.h>
#include <holdfast/base/lower_case.h>
#include <holdfast/io/files/file_bytes.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/io/formats/formats.h>

namespace holdfast {
namespace {

struct Format {
  std::string_view extension;
  MeshDocument (*read)(std::string bytes, const std::string& file);
  Serialized (*write)(const Positions& positions, const Polygons& faces);
};

constexpr std::array kFormats{Format{".obj", readObj, writeObj}, Format{".ply", readPly, writePly},
                              Format{".off", readOff, writeOff}, Format{".stl", readStl, writeStl}};

constexpr std::array<std::string_view, kFormats.size()> kExtensions{".obj", ".ply", ".off", ".stl"};

/// The format of `extension` in any case, or null.
const Format* findFormat(std::string_view extension)
{
  const auto* const format = std::ranges::find(kFormats, lowerCase(std::string(extension)), &Format::extension);
  return format == kFormats.end() ? nullptr : &*format;
}

std::string unknownFormat(std::string_view extension, std::span<const std::string_view> known)
{
  const std::string what = extension.empty()
                               ? "a name without an extension says no mesh format"
                               : fmt::format("{} is not a mesh format that is known here", quotedToken(extension));
  return fmt::format("{}: use {}", what, fmt::join(known, ", "));
}

}  // namespace

std::span<const std::string_view> meshExtensions()
{
  return kExtensions;
}

MeshDocument readMesh(const std::filesystem::path& path, std::span<const std::string_view> known)
{
  std::string bytes = readFileBytes(path);
  const std::string extension = path.extension().string();
  const Format* const format = findFormat(extension);
  if (format == nullptr) throw InputError({path.string(), 0, {}}, unknownFormat(extension, known));
  return format->read(std::move(bytes), path.string());
}

Serialized serializeMesh(const MeshDocument& document, const Positions& positions, std::string_view extension)
{
  assert(positions.rows() == document.mesh.vertexCount());
  const Format* const format = findFormat(extension);
  if (format == nullptr)
    throw OutputError(extension.empty() ? "(no extension)" : std::string(extension),
                      unknownFormat(extension, kExtensions));
  if (document.source && document.source->extension() == format->extension)
    return document.source->withPositions(document.mesh, positions);
  Serialized result = format->write(positions, document.mesh.faces);
  const std::vector<std::string> lost = document.source ? document.source->extras() : std::vector<std::string>{};
  if (!lost.empty())
    result.notes.push_back(fmt::format("left behind, because the format changes from {} to {}: {}",
                                       document.source->extension(), format->extension, fmt::join(lost, ", ")));
  return result;
}

std::vector<std::string> writeMesh(const std::filesystem::path& path, const MeshDocument& document,
                                   const Positions& positions)
{
  Serialized file = serializeMesh(document, positions, path.extension().string());
  OutputFile(path, file.bytes).commit();
  return std::move(file.notes);
}

}  // namespace holdfast
