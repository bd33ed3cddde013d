#include <array>

#include <vtkActor.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <holdfast/view/sliced_drawing.h>
#include <holdfast/view/stage.h>

namespace holdfast {

SlicedDrawing::SlicedDrawing(vtkRenderer& scene) : scene_(scene), window_(*scene.GetRenderWindow())
{
  slices_->SetActiveCamera(scene_.GetActiveCamera());
  slices_->SetLayer(scene_.GetLayer());
  addLights(*slices_);
  slices_->DrawOff();
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
  next_ = 0;
  slices_->AddActor(&contents.mesh().surface());
  slices_->SetGradientBackground(scene_.GetGradientBackground());
  slices_->SetBackground(scene_.GetBackground());
  slices_->SetBackground2(scene_.GetBackground2());
  std::array<double, 4> viewport{};
  scene_.GetViewport(viewport.data());
  slices_->SetViewport(viewport.data());
}

void SlicedDrawing::advance()
{
  if (next_ < contents_->mesh().sliceCount())
    drawSlice();
  else
    drawRest();
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
  contents_->mesh().showSlice(next_);
  drawOthers(0);
  slices_->SetErase(next_ == 0 ? 1 : 0);
  window_.SwapBuffersOff();
  window_.Render();
  ++next_;
}

void SlicedDrawing::drawRest()
{
  drawOthers(1);
  contents_->mesh().surface().VisibilityOff();
  scene_.EraseOff();
  window_.SwapBuffersOn();
  window_.Render();
  restore();
}

void SlicedDrawing::restore()
{
  drawOthers(1);
  scene_.EraseOn();
  window_.SwapBuffersOn();
  slices_->RemoveAllViewProps();
  contents_->mesh().surface().VisibilityOn();
  contents_->setDetail(Detail::Full);
  contents_ = nullptr;
}

void SlicedDrawing::abandon()
{
  if (isUnderWay()) restore();
}

}  // namespace holdfast
