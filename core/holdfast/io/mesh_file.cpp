#include "holdfast/io/mesh_file.h"

#include <fmt/ranges.h>

#include <holdfast/io/files/file_bytes.h>
#include <holdfast/io/files/output_file.h>
#include <holdfast/io/formats/formats.h>
#include <holdfast/io/text/encoding.h>
#include <holdfast/mesh/stated_places.h>
#include <holdfast/words/error.h>
#include <holdfast/words/lower_case.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

BlockCheck checkText(const std::string& file, std::uintmax_t /*size*/)
{
  return [blocks = TextBlocks(file)](std::string_view block) mutable { blocks.take(block); };
}

/// Looks at the first block alone.
BlockCheck checkHead(std::function<void(std::string_view)> check)
{
  return [check = std::move(check), isFirst = true](std::string_view block) mutable {
    if (std::exchange(isFirst, false)) check(block);
  };
}

BlockCheck checkPly(const std::string& file, std::uintmax_t /*size*/)
{
  return checkHead([file](std::string_view head) { checkPlyHead(head, file); });
}

BlockCheck checkStl(const std::string& file, std::uintmax_t size)
{
  return checkHead([file, size](std::string_view head) { checkStlHead(head, size, file); });
}

BlockCheck checkVtp(const std::string& file, std::uintmax_t /*size*/)
{
  return checkHead([file](std::string_view head) { checkVtpHead(head, file); });
}

struct Format {
  std::string_view extension;
  MeshDocument (*read)(std::string bytes, const std::string& file);             ///< null: it is written alone
  Serialized (*write)(const Mesh& rest, const Positions& positions);            ///< null: it is read alone
  BlockCheck (*check)(const std::string& file, std::uintmax_t size) = nullptr;  ///< of files that are read
  std::string_view whyUnread = {};                                              ///< the message where `read` is null
};

constexpr std::array kFormats{
    Format{".obj", readObj, writeObj, checkText},
    Format{".ply", readPly, writePly, checkPly},
    Format{".off", readOff, writeOff, checkText},
    Format{".stl", readStl, writeStl, checkStl},
    Format{".vtp", readVtp, writeVtp, checkVtp},
    Format{".vtk", nullptr, writeVtk, nullptr,
           "legacy VTK files (.vtk) are not read: save it as .vtp, for example in ParaView (Save Data)"}};

/// The extensions of the formats that have `member`, a reader or a writer.
std::vector<std::string_view> extensionsWith(auto Format::*member)
{
  std::vector<std::string_view> extensions;
  for (const Format& format : kFormats)
    if (format.*member != nullptr) extensions.push_back(format.extension);
  return extensions;
}

/// The format of `extension` in any case, or null.
const Format* findFormat(std::string_view extension)
{
  const auto* const format = std::ranges::find(kFormats, lowerCase(std::string(extension)), &Format::extension);
  return format == kFormats.end() ? nullptr : &*format;
}

/// The surface in another format: not all of them have faces of fewer than three corners.
Serialized surfaceIn(const Format& format, const Mesh& mesh, const Positions& positions)
{
  const auto leftOut = static_cast<Index>(facesWithoutSurface(mesh.faces).size());
  if (leftOut == 0) return format.write(mesh, positions);
  Serialized result = format.write(surfaceOf(mesh), positions);
  result.notes.push_back(counted(leftOut, "face") + " of fewer than three corners left behind");
  return result;
}

std::string unknownFormat(std::string_view extension, std::span<const std::string_view> known)
{
  const std::string what = extension.empty()
                               ? "a name without an extension says no mesh format"
                               : fmt::format("{} is not a mesh format that is known here", quotedToken(extension));
  return fmt::format("{}: use {}", what, fmt::join(known, ", "));
}

std::string whyUnread(const Format* format, std::string_view extension)
{
  return format == nullptr ? unknownFormat(extension, meshExtensions()) : std::string(format->whyUnread);
}

}  // namespace

std::span<const std::string_view> meshExtensions()
{
  static const std::vector<std::string_view> kExtensions = extensionsWith(&Format::read);
  return kExtensions;
}

std::span<const std::string_view> outputExtensions()
{
  static const std::vector<std::string_view> kExtensions = extensionsWith(&Format::write);
  return kExtensions;
}

MeshDocument readMesh(const std::filesystem::path& path)
{
  const std::string extension = path.extension().string();
  const Format* const format = findFormat(extension);
  if (format == nullptr || format->read == nullptr) {
    static_cast<void>(readFileBytes(path, [&](std::string_view /*block*/) {
      throw InputError({path.string(), 0, {}}, whyUnread(format, extension));
    }));
    return {};
  }
  std::error_code unknown;  // the reading that follows says what is wrong
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  return format->read(readFileBytes(path, format->check(path.string(), size)), path.string());
}

Serialized serializeMesh(const MeshDocument& document, const Positions& positions, std::string_view extension)
{
  assert(positions.rows() == document.mesh.vertexCount());
  const Format* const format = findFormat(extension);
  if (format == nullptr || format->write == nullptr)
    throw OutputError(extension.empty() ? "(no extension)" : std::string(extension),
                      unknownFormat(extension, outputExtensions()));
  const Positions stated = withStatedPlaces(document.mesh.positions, positions);
  if (document.source && document.source->extension() == format->extension)
    return document.source->withPositions(document.mesh, stated);
  Serialized result = surfaceIn(*format, document.mesh, stated);
  const std::vector<std::string> lost = document.source ? document.source->extras() : std::vector<std::string>{};
  if (!lost.empty())
    result.notes.push_back(fmt::format("left behind, because the format changes from {} to {}: {}",
                                       document.source->extension(), format->extension, fmt::join(lost, ", ")));
  return result;
}

Serialized serializeMeshFile(const MeshDocument& document, const Positions& positions,
                             const std::filesystem::path& path)
{
  try {
    return serializeMesh(document, positions, path.extension().string());
  } catch (const OutputError& error) {
    throw OutputError(path.string(), error.reason());
  }
}

std::vector<std::string> writeMesh(const std::filesystem::path& path, const MeshDocument& document,
                                   const Positions& positions)
{
  Serialized file = serializeMeshFile(document, positions, path);
  OutputFile(path, file.bytes).commit();
  return std::move(file.notes);
}

}  // namespace holdfast
