#include "holdfast/widgets/scene/kept_scene.h"

#include <vector>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkOpenGLFXAAFilter.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtk_glew.h>

namespace holdfast {
namespace {

// VTK draws into buffers of this depth, and depths are copied between equals only.
constexpr int kDepthBits = 32;

}  // namespace

KeptScene::KeptScene(vtkRenderer& scene, vtkRenderer& last)
    : scene_(scene), last_(last), window_(*vtkOpenGLRenderWindow::SafeDownCast(scene.GetRenderWindow()))
{
  kept_->SetContext(&window_);
  // It would take a line of one pixel for noise, and leave it faint and dotted.
  fxaa_->SetSubpixelBlendLimit(0);
  observer_ = last_.AddObserver(vtkCommand::EndEvent, this, &KeptScene::noteScene);
}

KeptScene::~KeptScene()
{
  last_.RemoveObserver(observer_);
  fxaa_->ReleaseGraphicsResources();
  kept_->ReleaseGraphicsResources(&window_);
}

bool KeptScene::isOutdated() const
{
  const int* size = window_.GetActualSize();
  return size_ != std::array{size[0], size[1]} || scene_.GetActiveCamera()->GetMTime() != cameraTime_;
}

void KeptScene::noteScene()
{
  const int* size = window_.GetActualSize();
  size_ = {size[0], size[1]};
  cameraTime_ = scene_.GetActiveCamera()->GetMTime();
  isKept_ = isKeeping_;
  if (!isKeeping_) return;
  if (kept_->GetFBOIndex() == 0) {
    window_.GetState()->PushFramebufferBindings();
    kept_->PopulateFramebuffer(size_[0], size_[1], true, 1, VTK_UNSIGNED_CHAR, true, kDepthBits, 0);
    window_.GetState()->PopFramebufferBindings();
  } else {
    kept_->Resize(size_[0], size_[1]);
  }
  copy(*window_.GetRenderFramebuffer(), *kept_);
  isRough_ = true;
}

void KeptScene::copy(vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to)
{
  const int* size = window_.GetActualSize();
  const std::array<int, 4> all{0, size[0], 0, size[1]};
  vtkOpenGLState& state = *window_.GetState();
  // The renderer that was drawn last leaves its viewport as the only part that may be written to.
  const vtkOpenGLState::ScopedglEnableDisable scissor(&state, GL_SCISSOR_TEST);
  state.vtkglDisable(GL_SCISSOR_TEST);
  state.PushFramebufferBindings();
  from.Bind(GL_READ_FRAMEBUFFER);
  from.ActivateReadBuffer(0);
  to.Bind(GL_DRAW_FRAMEBUFFER);
  to.ActivateDrawBuffer(0);
  vtkOpenGLFramebufferObject::Blit(all.data(), all.data(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state.PopFramebufferBindings();
}

/// Depths stay as they are: what is drawn above is hidden by the surface itself.
void KeptScene::smooth()
{
  vtkOpenGLState& state = *window_.GetState();
  const vtkOpenGLState::ScopedglEnableDisable scissor(&state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglViewport viewport(&state);
  state.vtkglDisable(GL_SCISSOR_TEST);
  state.vtkglViewport(0, 0, size_[0], size_[1]);
  state.PushFramebufferBindings();
  kept_->Bind();
  kept_->ActivateReadBuffer(0);
  kept_->ActivateDrawBuffer(0);
  fxaa_->Execute(vtkOpenGLRenderer::SafeDownCast(&scene_));
  state.PopFramebufferBindings();
  isRough_ = false;
}

void KeptScene::putBack()
{
  if (isRough_) smooth();
  copy(*kept_, *window_.GetRenderFramebuffer());
}

void KeptScene::drawLayersAbove()
{
  // The window binds what it draws in before its renderers draw; the first of them puts the scene there.
  std::vector<vtkRenderer*> hidden;
  vtkRendererCollection& renderers = *window_.GetRenderers();
  vtkRenderer* first = nullptr;
  for (int k = 0; k < renderers.GetNumberOfItems(); ++k) {
    auto* renderer = static_cast<vtkRenderer*>(renderers.GetItemAsObject(k));
    if (renderer->GetLayer() <= last_.GetLayer()) {
      if (renderer->GetDraw() != 0) hidden.push_back(renderer);
      renderer->DrawOff();
    } else if (first == nullptr || renderer->GetLayer() < first->GetLayer()) {
      first = renderer;
    }
  }
  const unsigned long tag =
      first != nullptr ? first->AddObserver(vtkCommand::StartEvent, this, &KeptScene::putBack) : 0;
  window_.Render();
  if (first != nullptr) first->RemoveObserver(tag);
  for (vtkRenderer* renderer : hidden) renderer->DrawOn();
}

}  // namespace holdfast
