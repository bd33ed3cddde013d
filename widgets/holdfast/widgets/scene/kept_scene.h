#pragma once
/// Drawing layers above a scene again without the scene, and smoothing the scene's edges.

#include <array>

#include <vtkNew.h>

class vtkOpenGLFXAAFilter;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace holdfast {

/// Keeps colours and depths of a scene each time that it is drawn, so that layers above it can be drawn again onto it.
/// The kept colours are smoothed once, by VTK's FXAA (T. Lottes, FXAA, NVIDIA 2009), when they are first used: the
/// picture at rest does not depend on whether the scene was drawn at once or in slices.
class KeptScene {
 public:
  /// The layers from that of `scene`, which fills the window, to that of `last`, which may be the same one; no other
  /// renderer is in the layer of `last`. Both are in a window without multisampling, which stays alive as long as this.
  KeptScene(vtkRenderer& scene, vtkRenderer& last);
  ~KeptScene();

  /// Whether scenes that are drawn from now on are kept; they are by default. A copy waits for what is being drawn,
  /// which is lost time where one scene follows another.
  void setKeeping(bool isKeeping) { isKeeping_ = isKeeping; }

  /// Whether the scene that was drawn last is kept, and not outdated.
  [[nodiscard]] bool isCurrent() const { return isKept_ && !isOutdated(); }

  /// Whether the scene is kept as it was drawn: the first `drawLayersAbove` smooths it.
  [[nodiscard]] bool isRough() const { return isCurrent() && isRough_; }

  /// Draws the layers above onto the kept scene with smooth edges, and shows the picture. The scene is current.
  void drawLayersAbove();

 private:
  /// Whether the camera has moved or the window got another size since the scene was drawn, or none was.
  [[nodiscard]] bool isOutdated() const;
  void noteScene();
  void putBack();
  void smooth();
  void copy(vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to);

  vtkRenderer& scene_;
  vtkRenderer& last_;
  vtkOpenGLRenderWindow& window_;
  vtkNew<vtkOpenGLFramebufferObject> kept_;
  vtkNew<vtkOpenGLFXAAFilter> fxaa_;
  unsigned long observer_ = 0;
  unsigned long cameraTime_ = 0;  // of the camera that the last scene was drawn with
  std::array<int, 2> size_{};     // of that picture
  bool isKeeping_ = true;
  bool isKept_ = false;
  bool isRough_ = false;  // what is kept is not smoothed
};

}  // namespace holdfast
