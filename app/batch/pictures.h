#pragma once
/// \file
/// Pictures of results, where this build has VTK to draw them with.

#include <filesystem>
#include <string>

#include <holdfast/deform/deform.h>

namespace holdfast::batch {

/// What `--snapshot`, `--color-by` and `--size` ask for.
struct PictureRequest {
  std::filesystem::path path;
  std::string colorBy;
  int width = 0;
  int height = 0;
};

/// Understands the three options. Throws `UsageError` for a build without VTK, a name that does not end in .png,
/// unknown values of `--color-by`, and sizes that are not WxH or out of range.
[[nodiscard]] PictureRequest pictureRequest(const std::filesystem::path& path, const std::string& colorBy,
                                            const std::string& size);

/// The values of `--color-by` as one text for people; empty in a build without VTK.
[[nodiscard]] std::string knownColorings();

/// Throws `OutputError` where no picture can be drawn here. Costs about a tenth of a second.
void requirePictures(const PictureRequest& request);

/// The bytes of the PNG file. Throws `OutputError`.
[[nodiscard]] std::string snapshot(const PictureRequest& request, const Model& model, const DeformResult& deformation,
                                   const std::string& units);

}  // namespace holdfast::batch
