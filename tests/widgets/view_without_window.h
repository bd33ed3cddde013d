#pragma once
/// \file
/// A renderer with a camera and a size, in a window that nobody opens: no display is needed.

#include <cmath>

#include <Eigen/Geometry>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/display_transform.h>

#include "plain_view.h"

namespace holdfast::test {

class ViewWithoutWindow {
 public:
  static constexpr int kWidth = 640;
  static constexpr int kHeight = 480;

  ViewWithoutWindow()
  {
    window_->SetOffScreenRendering(1);
    window_->SetSize(kWidth, kHeight);
    window_->AddRenderer(renderer_);
    renderer_->SetActiveCamera(camera_);
  }

  /// z is up, unless the view is along it. A parallel view is four units high.
  void lookFrom(const Vector3& direction, const Vector3& at, Projection projection)
  {
    const Vector3 back = direction.normalized();
    const Vector3 eye = at + 10 * back;
    camera_->SetPosition(eye.data());
    camera_->SetFocalPoint(at.data());
    std::abs(back.z()) > 0.99 ? camera_->SetViewUp(0, 1, 0) : camera_->SetViewUp(0, 0, 1);
    camera_->SetParallelProjection(projection == Projection::Parallel);
    camera_->SetParallelScale(2);
    camera_->SetClippingRange(1, 100);
  }

  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  [[nodiscard]] DisplayTransform view() { return DisplayTransform(*renderer_); }

 private:
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkCamera> camera_;
};

}  // namespace holdfast::test
