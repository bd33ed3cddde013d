#pragma once
/// A large mesh is drawn a few milliseconds at a time, so that a window can answer in between.

#include <vector>

#include <vtkNew.h>

#include <holdfast/widgets/scene/scene_contents.h>

class vtkRenderWindow;

namespace holdfast {

/// Draws what a window's renderer shows in parts. Slices of what is large come first, then all else. Nothing is shown
/// before the picture is whole. It is the picture that is drawn at once, pixel for pixel.
///
///     SlicedDrawing drawing(*renderer);
///     drawing.begin(scene);  // SceneContents, added to the renderer
///     while (drawing.isUnderWay()) {
///       drawing.advance();
///       handleEvents();  // of the program's event loop
///     }
class SlicedDrawing {
 public:
  /// Draws in `scene`, which is in a window and shows contents as `SceneContents::addTo` adds them. The window must
  /// stay alive as long as the drawing.
  explicit SlicedDrawing(vtkRenderer& scene);
  ~SlicedDrawing();

  /// Begins a picture of `contents`, which must stay as they are until it is done or abandoned. A picture that is under
  /// way is abandoned.
  void begin(SceneContents& contents);
  /// Orders the next part, and at last shows the picture. A picture must be under way. Drivers draw later, and showing
  /// waits for them. In a window that answers in between, each part is drawn before the next.
  void advance();
  [[nodiscard]] bool isUnderWay() const noexcept { return contents_ != nullptr; }
  /// Abandons the picture as if it had not begun. What was shown before is still shown.
  void abandon()
  {
    if (isUnderWay()) restore();
  }

 private:
  void drawSlice();
  void drawRest();
  void drawOthers(int isDrawn);
  void restore();

  vtkRenderer& scene_;
  vtkRenderWindow& window_;
  vtkNew<vtkRenderer> slices_;
  SceneContents* contents_ = nullptr;
  std::vector<ActorSlices*> parts_;
  std::size_t part_ = 0;  // the next part
  Index slice_ = 0;
  bool isWhole_ = false;  // all is drawn, and nothing is shown yet
};

}  // namespace holdfast
