#pragma once
/// A deformed mesh with all that explains it, drawn without a window; its picture as pixels and as a PNG file.

#include <optional>
#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <holdfast/widgets/scene/scene_contents.h>

namespace holdfast {

struct LegendContents;

struct PictureSize {
  int width = 1280;
  int height = 960;
};

/// Both sides of a picture, in pixels.
inline constexpr int kLeastPictureSide = 16;
inline constexpr int kLargestPictureSide = 16384;
/// 8192 x 8192 or as many otherwise. Drawing so many takes 2.5 GiB of memory.
inline constexpr int kMostPicturePixels = 8192 * 8192;

/// Whether a picture of sides that are allowed has too many pixels.
[[nodiscard]] constexpr bool hasTooManyPixels(const PictureSize& size)
{
  return size.width > kMostPicturePixels / size.height;
}

enum class Legend {
  Shown,  ///< where the picture is at least `kLeastLegendWidth` x `kLeastLegendHeight`
  Hidden
};

inline constexpr int kLeastLegendWidth = 240;
inline constexpr int kLeastLegendHeight = 200;

struct SceneOptions {
  PictureSize size;
  ColorBy colorBy = ColorBy::Displacement;
  Legend legend = Legend::Shown;
  std::string units;  ///< the user's name of the model's length; may be empty
  /// In the place of what `colorBy` would make: colours over a range or of a map that a user has chosen.
  std::optional<Coloring> coloring = std::nullopt;
  /// In the place of VTK's own window, which needs an X server with OpenGL: see `whyNoPictures`. Null: that one.
  vtkSmartPointer<vtkRenderWindow> window = nullptr;
};

/// The deformed surface with its sharp edges, those of the rest shape in faint lines, the constraints, the legend; in a
/// window that is never shown. Drawn by `draw`.
class Scene {
 public:
  Scene(const Model& model, const DeformResult& deformation, const SceneOptions& options);

  [[nodiscard]] vtkRenderWindow& window() const { return *window_; }
  /// Its camera can be moved.
  [[nodiscard]] vtkRenderer& meshRenderer() const { return *meshRenderer_; }
  [[nodiscard]] SceneContents& contents() { return contents_; }
  [[nodiscard]] MeshActor& mesh() { return contents_.mesh(); }

  /// One colour in the place of the usual background.
  void setBackdrop(const Color& color);

  [[nodiscard]] PictureSize size() const noexcept { return size_; }
  /// The window has this many pixels for each of the picture, along both sides; `draw` takes the mean.
  [[nodiscard]] int pixelRatio() const noexcept { return pixelRatio_; }

 private:
  void placeCamera(const Model& model, const DeformResult& deformation);
  void layOut(const LegendContents& contents, double textSize);

  PictureSize size_;
  int pixelRatio_;
  SceneContents contents_;
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> backdrop_;  // the background and the legend, under the mesh
  vtkNew<vtkRenderer> meshRenderer_;
};

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
