#include "batch/pictures.h"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#ifdef HOLDFAST_WITH_VTK
#include <holdfast/base/error.h>
#include <holdfast/base/printable.h>
#include <holdfast/widgets/scene/display_check.h>
#include <holdfast/widgets/scene/scene.h>
#endif

#include "batch/mesh_formats.h"
#include "batch/options.h"

namespace holdfast::batch {

#ifdef HOLDFAST_WITH_VTK
namespace {

std::optional<int> sideOf(std::string_view text)
{
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (side < kLeastPictureSide || side > kLargestPictureSide) return std::nullopt;
  return side;
}

PictureSize sizeOf(const std::string& text)
{
  const std::string_view whole = text;
  const auto cross = whole.find('x');
  const auto width = sideOf(whole.substr(0, cross));
  const auto height = cross == std::string_view::npos ? std::nullopt : sideOf(whole.substr(cross + 1));
  if (!width || !height)
    throw UsageError(fmt::format("--size: {} is not WIDTHxHEIGHT in pixels, each from {} to {}, such as 1280x960",
                                 inQuotes(text), kLeastPictureSide, kLargestPictureSide));
  const PictureSize pixels{*width, *height};
  if (hasTooManyPixels(pixels))
    throw UsageError(fmt::format(
        "--size: {} has more than {} pixels, for which drawing takes 2.5 GiB of memory; ask for 8192x8192 or less",
        printable(text), kMostPicturePixels));
  return pixels;
}

}  // namespace

std::string knownColorings()
{
  std::string known;
  for (const std::string_view name : colorByNames()) known += fmt::format("{}{}", known.empty() ? "" : ", ", name);
  return known;
}

PictureRequest pictureRequest(const std::filesystem::path& path, const std::string& colorBy, const std::string& size)
{
  if (extensionOf(path) != ".png")
    throw UsageError(fmt::format("--snapshot: \"{}\" does not end in .png", printable(path.string())));
  if (!colorByNamed(colorBy))
    throw UsageError(fmt::format("--color-by: {} is not one of {}", inQuotes(colorBy), knownColorings()));
  const PictureSize pixels = sizeOf(size);
  return {path, colorBy, pixels.width, pixels.height};
}

void requirePictures(const PictureRequest& request)
{
  if (const std::string reason = whyNoPictures(); !reason.empty()) throw OutputError(request.path.string(), reason);
}

std::string snapshot(const PictureRequest& request, const Model& model, const DeformResult& deformation,
                     const std::string& units)
{
  const Scene scene(model, deformation,
                    {{request.width, request.height}, colorByNamed(request.colorBy).value(), Legend::Shown, units});
  return toPng(draw(scene, request.path.string()), request.path.string());
}

#else

std::string knownColorings()
{
  return {};
}

PictureRequest pictureRequest(const std::filesystem::path& path, const std::string& /*colorBy*/,
                              const std::string& /*size*/)
{
  throw UsageError("--snapshot: this build has no VTK to draw \"" + path.string() + "\" with; leave the option out");
}

void requirePictures(const PictureRequest& /*request*/)
{
  throw std::logic_error("a picture was asked for in a build without VTK");
}

std::string snapshot(const PictureRequest& /*request*/, const Model& /*model*/, const DeformResult& /*deformation*/,
                     const std::string& /*units*/)
{
  throw std::logic_error("a picture was asked for in a build without VTK");
}

#endif

}  // namespace holdfast::batch
