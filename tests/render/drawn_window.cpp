#include "render/drawn_window.h"

#include <vtkUnsignedCharArray.h>

namespace holdfast::test {

OffscreenWindow::OffscreenWindow(const PictureSize& size) : size_(size)
{
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(0);
  window_->SetDPI(72);
  window_->SetSize(size.width, size.height);
  window_->AddRenderer(renderer_);
}

Picture OffscreenWindow::drawn() const
{
  window_->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  constexpr int kBackBuffer = 0;
  window_->GetPixelData(0, 0, size_.width - 1, size_.height - 1, kBackBuffer, pixels);
  return {size_, {pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues()}};
}

}  // namespace holdfast::test
