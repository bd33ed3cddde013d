#pragma once
/// \file
/// Windows that are never shown, and what is drawn in them.

#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/scene/scene.h>

namespace holdfast::test {

/// Hides all that VTK writes in a window: fonts differ from machine to machine, so no text is part of a baseline.
void hideTexts(vtkRenderWindow& window);

/// What VTK writes in a window, in the order of the actors.
[[nodiscard]] std::vector<std::string> textsIn(vtkRenderWindow& window);

/// VTK draws into the one, and a window shows the other.
enum class DrawnBuffer { Back = 0, Front = 1 };

/// All pixels of a buffer as they are: RGB, rows from the bottom.
[[nodiscard]] std::vector<unsigned char> pixelsOf(vtkRenderWindow& window, DrawnBuffer buffer);

/// A window with one renderer, drawn offscreen. One pixel of the window is one of the picture.
class OffscreenWindow {
 public:
  explicit OffscreenWindow(const PictureSize& size);

  [[nodiscard]] vtkRenderWindow& window() const { return *window_; }
  [[nodiscard]] vtkRenderer& renderer() const { return *renderer_; }
  [[nodiscard]] Picture drawn() const;

 private:
  PictureSize size_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace holdfast::test
