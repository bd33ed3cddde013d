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

std::vector<unsigned char> pixelsOf(vtkRenderWindow& window, DrawnBuffer buffer)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window.GetPixelData(0, 0, window.GetSize()[0] - 1, window.GetSize()[1] - 1, static_cast<int>(buffer), pixels);
  return {pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues()};
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
  return {size_, pixelsOf(*window_, DrawnBuffer::Back)};
}

}  // namespace holdfast::test
