#pragma once
/// A scene draws a deformed mesh with all that explains it, without a window. Its picture becomes pixels and a PNG
/// file.

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

/// The size of a picture, in pixels.
struct PictureSize {
  int width = 1280;
  int height = 960;
};

/// The least and the largest side of a picture, in pixels.
inline constexpr int kLeastPictureSide = 16;
inline constexpr int kLargestPictureSide = 16384;
/// A picture has no more pixels than this: 8192 x 8192, or as many with other sides. Drawing so many takes 2.5 GiB of
/// memory.
inline constexpr int kMostPicturePixels = 8192 * 8192;

/// Tells whether a picture of sides that are allowed has too many pixels.
[[nodiscard]] constexpr bool hasTooManyPixels(const PictureSize& size)
{
  return size.width > kMostPicturePixels / size.height;
}

/// This option says whether a picture has a legend.
enum class Legend {
  Shown,  ///< the legend is in pictures of at least `kLeastLegendWidth` x `kLeastLegendHeight`
  Hidden
};

/// A picture of fewer pixels along either side has no legend.
inline constexpr int kLeastLegendWidth = 240;
inline constexpr int kLeastLegendHeight = 200;

/// The options say what a scene shows and how large its picture is.
struct SceneOptions {
  PictureSize size;
  ColorBy colorBy = ColorBy::Displacement;
  Legend legend = Legend::Shown;
  std::string units;  ///< the user's name of the model's length; may be empty
  /// These colours replace those that `colorBy` would make. They may be over a range or of a map that a user has
  /// chosen.
  std::optional<Coloring> coloring = std::nullopt;
  /// This window replaces VTK's own, which needs an X server with OpenGL (`whyNoPictures`). Null means VTK's own.
  vtkSmartPointer<vtkRenderWindow> window = nullptr;
};

/// A deformed surface in a window that is never shown. The scene has its sharp edges, those of the rest shape in faint
/// lines, the constraints and the legend. `draw` draws it.
///
///     SceneOptions options;
///     options.colorBy = ColorBy::ConstraintResidual;
///     options.units = "mm";
///     const Scene scene(model, result, options);
///     const std::string png = toPng(draw(scene, "part.png"), "part.png");
///     std::ofstream("part.png", std::ios::binary) << png;
class Scene {
 public:
  Scene(const Model& model, const DeformResult& deformation, const SceneOptions& options);

  [[nodiscard]] vtkRenderWindow& window() const { return *window_; }
  /// Returns the renderer of the mesh. Its camera can be moved.
  [[nodiscard]] vtkRenderer& meshRenderer() const { return *meshRenderer_; }
  [[nodiscard]] SceneContents& contents() { return contents_; }
  [[nodiscard]] MeshActor& mesh() { return contents_.mesh(); }

  /// Draws one colour in place of the usual background.
  void setBackdrop(const Color& color);

  [[nodiscard]] PictureSize size() const noexcept { return size_; }
  /// Returns how many pixels of the window make one of the picture, along both sides. `draw` takes their mean.
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

/// A picture as pixels: RGB, one byte for each channel, rows from the bottom.
struct Picture {
  PictureSize size;
  std::vector<unsigned char> pixels;  ///< 3 width height bytes
};

/// Draws `scene`. Messages call the picture `name`. Every run gives the same pixels. Throws `OutputError` where the
/// picture has more than `kMostPicturePixels`. It also throws where OpenGL cannot hold a picture of this size, or
/// fails.
[[nodiscard]] Picture draw(const Scene& scene, const std::string& name);

/// Returns the picture as the contents of a PNG file. Every run gives the same bytes. Throws `OutputError` where VTK
/// fails.
[[nodiscard]] std::string toPng(const Picture& picture, const std::string& name);

}  // namespace holdfast
