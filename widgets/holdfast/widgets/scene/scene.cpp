#include "holdfast/widgets/scene/scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPNGWriter.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/deform/outcomes.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/color/scalar_legend.h>
#include <holdfast/widgets/scene/lighting.h>
#include <holdfast/widgets/scene/vtk_error_log.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

// Pixels of larger pictures are fine enough as they are, and no OpenGL need hold a window of twice their size.
constexpr int kLargestSmoothedSide = 4096;

// In sizes of the text.
constexpr double kLegendWidth = 11.5;
constexpr double kBallSize = 0.62;

int pixelRatioOf(const PictureSize& size)
{
  return std::max(size.width, size.height) <= kLargestSmoothedSide ? 2 : 1;
}

/// In pixels of the window. Grows with the picture, so that a picture looks the same at every size.
double textSizeOf(const PictureSize& size, int pixelRatio)
{
  return pixelRatio * std::max(9.0, std::round(std::min(size.height / 48.0, size.width / 64.0)));
}

std::vector<KeyEntry> keyOf(const Report& report)
{
  std::vector<KeyEntry> key;
  for (const ConstraintStatus status :
       {ConstraintStatus::Met, ConstraintStatus::Redundant, ConstraintStatus::Conflicting, ConstraintStatus::Missed})
    if (const Index count = countOf(report, status); count > 0)
      key.push_back({glyphColor(status), fmt::format("{} {}", count, name(status))});
  return key;
}

constexpr int kChannels = 3;

[[noreturn]] void fail(const std::string& name, const std::string& reason)
{
  throw OutputError(name, "the picture cannot be drawn: " + reason);
}

/// A framebuffer that OpenGL cannot hold is a crash of the driver, not an error of VTK.
void requireRoom(vtkRenderWindow& window, const std::string& name)
{
  auto* openGl = vtkOpenGLRenderWindow::SafeDownCast(&window);
  if (openGl == nullptr) fail(name, "VTK has no OpenGL here; install a VTK with the module RenderingOpenGL2");
  openGl->Initialize();
  const int* const size = window.GetSize();
  const int side = std::max(size[0], size[1]);
  const int largest = vtkTextureObject::GetMaximumTextureSize(openGl);
  if (largest > 0 && side > largest)
    fail(name, "OpenGL has room for " + std::to_string(largest) + " pixels a side here, and " + std::to_string(side) +
                   " are needed; ask for a smaller size");
}

/// The mean of `ratio` x `ratio` pixels of the window for each of the picture.
Picture averaged(const vtkUnsignedCharArray& drawn, const PictureSize& size, int ratio)
{
  Picture picture{size, {}};
  picture.pixels.reserve(static_cast<std::size_t>(kChannels) * size.width * size.height);
  const std::ptrdiff_t rowLength = static_cast<std::ptrdiff_t>(kChannels) * ratio * size.width;
  const unsigned char* const first = const_cast<vtkUnsignedCharArray&>(drawn).GetPointer(0);
  for (std::ptrdiff_t y = 0; y < size.height; ++y)
    for (std::ptrdiff_t x = 0; x < size.width; ++x)
      for (int channel = 0; channel < kChannels; ++channel) {
        int sum = ratio * ratio / 2;
        for (int dy = 0; dy < ratio; ++dy)
          for (int dx = 0; dx < ratio; ++dx)
            sum += first[(y * ratio + dy) * rowLength + (x * ratio + dx) * kChannels + channel];
        picture.pixels.push_back(static_cast<unsigned char>(sum / (ratio * ratio)));
      }
  return picture;
}

}  // namespace

Scene::Scene(const Model& model, const DeformResult& deformation, const SceneOptions& options)
    : size_(options.size),
      pixelRatio_(pixelRatioOf(size_)),
      contents_(model),
      window_(options.window ? options.window : vtkSmartPointer<vtkRenderWindow>::New())
{
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(0);
  window_->SetDPI(72);
  window_->SetSize(pixelRatio_ * size_.width, pixelRatio_ * size_.height);
  window_->SetNumberOfLayers(2);
  window_->AddRenderer(backdrop_);
  window_->AddRenderer(meshRenderer_);
  meshRenderer_->SetLayer(1);
  addBackground(*backdrop_);
  addLights(*meshRenderer_);

  const auto coloring = options.coloring ? options.coloring
                                         : coloringOf(model, deformation, ColorSettings{options.colorBy}, options.units,
                                                      contents_.mesh().shaded().get());
  contents_.setHiddenMarks(HiddenMarks::Invisible);
  contents_.show(deformation);
  contents_.color(coloring);
  contents_.addTo(*meshRenderer_);

  LegendContents legend;
  if (coloring) legend.scale = coloring->scale;
  legend.key = keyOf(deformation.report);
  const bool isLarge = size_.width >= kLeastLegendWidth && size_.height >= kLeastLegendHeight;
  if (options.legend == Legend::Hidden || !isLarge) legend = {};
  layOut(legend, textSizeOf(size_, pixelRatio_));
  placeCamera(model, deformation);
}

void Scene::setBackdrop(const Color& color)
{
  backdrop_->GradientBackgroundOff();
  backdrop_->SetBackground(color.red, color.green, color.blue);
}

void Scene::layOut(const LegendContents& contents, double textSize)
{
  contents_.setPixelRatio(pixelRatio_);
  contents_.setBallSize(kBallSize * textSize / pixelRatio_);
  if (contents.isEmpty()) return;
  const double width = pixelRatio_ * size_.width;
  const double legendWidth = kLegendWidth * textSize;
  meshRenderer_->SetViewport(0, 0, 1 - legendWidth / width, 1);
  addLegend(*backdrop_, contents,
            {width - legendWidth, legendWidth, static_cast<double>(pixelRatio_) * size_.height, textSize});
}

void Scene::placeCamera(const Model& model, const DeformResult& deformation)
{
  const double* const viewport = meshRenderer_->GetViewport();
  const double aspect = (viewport[2] - viewport[0]) * size_.width / size_.height;
  Positions all(2 * deformation.positions.rows(), 3);
  all << model.mesh.positions, deformation.positions;
  fit(*meshRenderer_->GetActiveCamera(), defaultFrame(all), all, aspect);
  meshRenderer_->ResetCameraClippingRange();
}

Picture draw(const Scene& scene, const std::string& name)
{
  if (hasTooManyPixels(scene.size()))
    fail(name, "it would have more than 8192 x 8192 pixels, and take more than 2.5 GiB of memory; ask for fewer");
  VtkErrorLog log;
  vtkRenderWindow& window = scene.window();
  log.watch(window);
  requireRoom(window, name);
  window.Render();
  vtkNew<vtkUnsignedCharArray> drawn;
  const int ratio = scene.pixelRatio();
  const PictureSize size = scene.size();
  constexpr int kBackBuffer = 0;
  window.GetPixelData(0, 0, ratio * size.width - 1, ratio * size.height - 1, kBackBuffer, drawn);
  if (!log.isEmpty()) fail(name, log.first());
  const auto expected = static_cast<vtkIdType>(kChannels) * ratio * size.width * ratio * size.height;
  if (drawn->GetNumberOfValues() != expected) fail(name, "OpenGL gave back no pixels; ask for a smaller size");
  return averaged(*drawn, size, ratio);
}

std::string toPng(const Picture& picture, const std::string& name)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.size.width, picture.size.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, kChannels);
  std::copy(picture.pixels.begin(), picture.pixels.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  VtkErrorLog log;
  vtkNew<vtkPNGWriter> writer;
  log.watch(*writer);
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  if (!log.isEmpty() || bytes == nullptr) fail(name, log.isEmpty() ? "VTK wrote no PNG" : log.first());
  return {bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues()};
}

}  // namespace holdfast
