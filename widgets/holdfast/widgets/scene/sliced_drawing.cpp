#include "holdfast/widgets/scene/sliced_drawing.h"

#include <vtkActor.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <holdfast/widgets/scene/lighting.h>

namespace holdfast {
namespace {

/// Sets whether the renderer draws onto the picture that is there. With `SetErase` VTK would keep Qt's state of OpenGL,
/// which tests no depths.
void setOnTop(vtkRenderer& renderer, bool isOnTop)
{
  renderer.SetPreserveColorBuffer(isOnTop ? 1 : 0);
  renderer.SetPreserveDepthBuffer(isOnTop ? 1 : 0);
}

}  // namespace

SlicedDrawing::SlicedDrawing(vtkRenderer& scene) : scene_(scene), window_(*scene.GetRenderWindow())
{
  slices_->SetActiveCamera(scene_.GetActiveCamera());
  slices_->SetLayer(scene_.GetLayer());
  addLights(*slices_);
  slices_->DrawOff();
  slices_->InteractiveOff();
  window_.AddRenderer(slices_);
}

SlicedDrawing::~SlicedDrawing()
{
  abandon();
  window_.RemoveRenderer(slices_);
}

void SlicedDrawing::begin(SceneContents& contents)
{
  abandon();
  contents_ = &contents;
  contents.setDetail(Detail::Full);
  parts_ = contents.slices();
  part_ = 0;
  slice_ = 0;
  isWhole_ = false;
  slices_->SetGradientBackground(scene_.GetGradientBackground());
  slices_->SetBackground(scene_.GetBackground());
  slices_->SetBackground2(scene_.GetBackground2());
  slices_->SetViewport(scene_.GetViewport());
}

void SlicedDrawing::advance()
{
  if (part_ < parts_.size())
    drawSlice();
  else if (!isWhole_)
    drawRest();
  else {
    window_.SwapBuffersOn();
    window_.Frame();
    restore();
  }
}

void SlicedDrawing::drawOthers(int isDrawn)
{
  vtkRendererCollection& renderers = *window_.GetRenderers();
  for (int k = 0; k < renderers.GetNumberOfItems(); ++k)
    static_cast<vtkRenderer*>(renderers.GetItemAsObject(k))->SetDraw(isDrawn);
  slices_->SetDraw(isDrawn == 0 ? 1 : 0);
}

void SlicedDrawing::drawSlice()
{
  ActorSlices& part = *parts_[part_];
  if (slice_ == 0) {
    slices_->RemoveAllViewProps();
    slices_->AddActor(&part.actor());
  }
  part.show(slice_);
  drawOthers(0);
  setOnTop(*slices_, part_ > 0 || slice_ > 0);
  window_.SwapBuffersOff();
  window_.Render();
  if (++slice_ < part.count()) return;
  ++part_;
  slice_ = 0;
}

void SlicedDrawing::drawRest()
{
  drawOthers(1);
  for (const ActorSlices* part : parts_) part->actor().VisibilityOff();
  setOnTop(scene_, true);
  window_.SwapBuffersOff();
  window_.Render();
  isWhole_ = true;
}

void SlicedDrawing::restore()
{
  drawOthers(1);
  setOnTop(scene_, false);
  window_.SwapBuffersOn();
  slices_->RemoveAllViewProps();
  for (ActorSlices* part : parts_) {
    part->actor().VisibilityOn();
    part->showWhole();
  }
  parts_.clear();
  contents_ = nullptr;
}

}  // namespace holdfast
