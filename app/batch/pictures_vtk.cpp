#include <charconv>
#include <optional>

#include <fmt/ranges.h>

#include <holdfast/widgets/scene/display_check.h>
#include <holdfast/widgets/scene/scene.h>
#include <holdfast/words/lower_case.h>
#include <holdfast/words/printable.h>

#include "batch/batch.h"

namespace holdfast::batch {
namespace {

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

}  // namespace

void requirePicture(const PictureRequest& picture)
{
  const auto& [path, colorBy, size] = picture;
  if (lowerCase(std::filesystem::path(path).extension().string()) != ".png")
    throw UsageError(fmt::format("--snapshot: \"{}\" does not end in .png", printable(path)));
  if (!colorByNamed(colorBy))
    throw UsageError(fmt::format("--color-by: {} is not one of {}", inQuotes(colorBy), knownColorings()));
  static_cast<void>(sizeOf(size));
}

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

void goOnWithVtk(char** /*argv*/) {}

}  // namespace holdfast::batch
