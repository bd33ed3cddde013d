#pragma once
/// \file
/// Pictures of scenes: pixels and PNG files.

#include <string>
#include <vector>

#include <holdfast/widgets/scene/scene.h>

namespace holdfast {

/// RGB, a byte a channel, rows from the bottom.
struct Picture {
  PictureSize size;
  std::vector<unsigned char> pixels;  ///< 3 width height
};

/// Draws `scene`; `name` names the picture in messages. The same pixels on every run. Throws `OutputError` where the
/// picture has more than `kMostPicturePixels`, and where OpenGL cannot hold one of this size, or fails.
[[nodiscard]] Picture draw(const Scene& scene, const std::string& name);

/// The picture as the contents of a PNG file. The same bytes on every run. Throws `OutputError` where VTK fails.
[[nodiscard]] std::string toPng(const Picture& picture, const std::string& name);

}  // namespace holdfast
