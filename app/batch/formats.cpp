#include <fmt/ranges.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/words/error.h>
#include <holdfast/words/lower_case.h>
#include <holdfast/words/printable.h>

#include "batch/batch.h"

namespace holdfast::batch {
namespace {

/// Lower case with the dot: ".obj".
std::string extensionOf(const std::filesystem::path& path)
{
  return lowerCase(path.extension().string());
}

void requireMeshExtension(std::string_view option, const std::string& path, const auto& known)
{
  if (!path.empty() && std::find(known.begin(), known.end(), extensionOf(path)) == known.end())
    throw UsageError(
        fmt::format("{}: \"{}\" has none of the extensions {}", option, printable(path), fmt::join(known, ", ")));
}

}  // namespace

std::string knownFormats()
{
  return fmt::format("{}", fmt::join(meshExtensions(), ", "));
}

void requireFormats(const Command& command)
{
  requireMeshExtension("--out", command.out, outputExtensions());
  if (!command.fields.empty() && extensionOf(command.fields) != ".vtp")
    throw UsageError(fmt::format("--fields: \"{}\" does not end in .vtp", printable(command.fields)));
  if (!command.picture.path.empty()) requirePicture(command.picture);
}

}  // namespace holdfast::batch
