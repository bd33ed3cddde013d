#pragma once
/// \file
/// Windows that are never shown, and what is drawn in them.

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/view/snapshot.h>

namespace holdfast::test {

/// A window with one renderer, drawn offscreen. One pixel of the window is one of the picture.
class OffscreenWindow {
 public:
  explicit OffscreenWindow(const PictureSize& size);

  [[nodiscard]] vtkRenderer& renderer() const { return *renderer_; }
  [[nodiscard]] Picture drawn() const;

 private:
  PictureSize size_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace holdfast::test
