#include "render/drawn_window.h"

#include <vtkPropCollection.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

namespace holdfast::test {
namespace {

std::vector<vtkTextActor*> textActors(vtkRenderWindow& window)
{
  std::vector<vtkTextActor*> found;
  vtkRendererCollection& renderers = *window.GetRenderers();
  for (int r = 0; r < renderers.GetNumberOfItems(); ++r) {
    vtkPropCollection& props = *static_cast<vtkRenderer*>(renderers.GetItemAsObject(r))->GetViewProps();
    for (int k = 0; k < props.GetNumberOfItems(); ++k)
      if (auto* const text = vtkTextActor::SafeDownCast(props.GetItemAsObject(k))) found.push_back(text);
  }
  return found;
}

}  // namespace

void hideTexts(vtkRenderWindow& window)
{
  for (vtkTextActor* const text : textActors(window)) text->GetTextProperty()->SetOpacity(0);
}

std::vector<std::string> textsIn(vtkRenderWindow& window)
{
  std::vector<std::string> texts;
  for (vtkTextActor* const actor : textActors(window)) texts.emplace_back(actor->GetInput());
  return texts;
}

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
