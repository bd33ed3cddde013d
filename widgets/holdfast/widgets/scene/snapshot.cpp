#include "holdfast/widgets/scene/snapshot.h"

#include <algorithm>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/base/error.h>
#include <holdfast/widgets/files/vtk_error_log.h>

namespace holdfast {
namespace {

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
