#include <charconv>
#include <optional>

#include <fmt/ranges.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/words/error.h>
#include <holdfast/words/lower_case.h>
#include <holdfast/words/printable.h>

#include "batch/batch.h"
#ifdef HOLDFAST_WITH_VTK
#include <holdfast/widgets/scene/display_check.h>
#include <holdfast/widgets/scene/scene.h>
#endif

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

#ifdef HOLDFAST_WITH_VTK

std::optional<int> sideOf(std::string_view text)
{
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (side < kLeastPictureSide || side > kLargestPictureSide) return std::nullopt;
  return side;
}

PictureSize sizeOf(std::string_view text)
{
  const auto cross = text.find('x');
  const auto width = sideOf(text.substr(0, cross));
  const auto height = cross == std::string_view::npos ? std::nullopt : sideOf(text.substr(cross + 1));
  if (!width || !height)
    throw UsageError(fmt::format("--size: {} is not WIDTHxHEIGHT in pixels, each from {} to {}, such as 1280x960",
                                 inQuotes(text), kLeastPictureSide, kLargestPictureSide));
  if (hasTooManyPixels({*width, *height}))
    throw UsageError(fmt::format(
        "--size: {} has more than {} pixels, for which drawing takes 2.5 GiB of memory; ask for 8192x8192 or less",
        printable(text), kMostPicturePixels));
  return {*width, *height};
}

void requirePicture(const PictureRequest& picture)
{
  const auto& [path, colorBy, size] = picture;
  if (extensionOf(path) != ".png")
    throw UsageError(fmt::format("--snapshot: \"{}\" does not end in .png", printable(path)));
  if (!colorByNamed(colorBy))
    throw UsageError(fmt::format("--color-by: {} is not one of {}", inQuotes(colorBy), knownColorings()));
  static_cast<void>(sizeOf(size));
}

#else

void requirePicture(const PictureRequest& picture)
{
  throw UsageError("--snapshot: there is no VTK to draw \"" + picture.path + "\" with; leave the option out");
}

#endif

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

#ifdef HOLDFAST_WITH_VTK

std::string knownColorings()
{
  return fmt::format("{}", fmt::join(colorByNames(), ", "));
}

void requireDisplay(const PictureRequest& picture)
{
  if (const std::string reason = whyNoPictures(); !reason.empty()) throw OutputError(picture.path, reason);
}

std::string snapshot(const PictureRequest& picture, const Model& model, const DeformResult& deformation,
                     const std::string& units)
{
  const Scene scene(model, deformation,
                    {sizeOf(picture.size), colorByNamed(picture.colorBy).value(), Legend::Shown, units});
  return toPng(draw(scene, picture.path), picture.path);
}

#else

std::string knownColorings()
{
  return {};
}

// Options that ask for these are refused.
void requireDisplay(const PictureRequest& /*picture*/) {}
std::string snapshot(const PictureRequest& /*picture*/, const Model& /*model*/, const DeformResult& /*deformation*/,
                     const std::string& /*units*/)
{
  return {};
}

#endif

}  // namespace holdfast::batch
