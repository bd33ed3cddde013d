#pragma once
/// Drawing a large mesh a few milliseconds at a time, so that a window can answer in between.

#include <vector>

#include <vtkNew.h>

#include <holdfast/widgets/scene/scene_contents.h>

class vtkRenderWindow;

namespace holdfast {

/// Draws what a window's renderer shows in parts: slices of what is large first, then all else, without showing
/// anything before it is whole. The finished picture is the one that is drawn at once, pixel for pixel.
class SlicedDrawing {
 public:
  /// `scene` is in a window, which stays alive as long as this, and shows contents as `SceneContents::addTo` adds them.
  explicit SlicedDrawing(vtkRenderer& scene);
  ~SlicedDrawing();

  /// Begins a picture of `contents`, which stay as they are until it is done or abandoned. Abandons one under way.
  void begin(SceneContents& contents);
  /// Orders the next part, and at last shows the picture. One is under way. Drivers draw later, and showing waits for
  /// them: a window that answers in between lets each part be drawn before the next.
  void advance();
  [[nodiscard]] bool isUnderWay() const noexcept { return contents_ != nullptr; }
  /// As if it had not begun: what was shown before is still shown.
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
  std::size_t part_ = 0;  // the part and the slice of it that are next
  Index slice_ = 0;
  bool isWhole_ = false;  // all is drawn, and nothing is shown yet
};

}  // namespace holdfast
