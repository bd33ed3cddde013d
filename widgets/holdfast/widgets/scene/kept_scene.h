#pragma once
/// A kept scene has smooth edges, and layers above it are drawn again without it.

#include <array>

#include <vtkNew.h>

class vtkOpenGLFXAAFilter;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace holdfast {

/// Keeps colours and depths of a scene each time that it is drawn. Layers above it can then be drawn again onto it.
/// VTK's FXAA (T. Lottes, FXAA, NVIDIA 2009) smooths the kept colours once, when they are first used. The picture at
/// rest does not depend on whether the scene was drawn at once or in slices.
///
///     KeptScene kept(*renderer, *renderer);  // the widgets are in a renderer of a layer above
///     window->Render();
///     const auto drawAgain = [&] { kept.isCurrent() ? kept.drawLayersAbove() : window->Render(); };
class KeptScene {
 public:
  /// Keeps the layers from that of `scene` to that of `last`, which may be the same renderer. `scene` fills the window.
  /// No other renderer is in the layer of `last`. Both are in a window without multisampling. The window must stay
  /// alive as long as the kept scene.
  KeptScene(vtkRenderer& scene, vtkRenderer& last);
  ~KeptScene();

  /// Sets whether scenes that are drawn from now on are kept. They are by default. A copy waits for what is being
  /// drawn. Where one scene follows another, that time is lost.
  void setKeeping(bool isKeeping) { isKeeping_ = isKeeping; }

  /// Tells whether the scene that was drawn last is kept and not outdated. It is outdated when the camera has moved or
  /// the window has another size.
  [[nodiscard]] bool isCurrent() const { return isKept_ && !isOutdated(); }

  /// Tells whether the scene is kept as it was drawn. The first `drawLayersAbove` smooths it.
  [[nodiscard]] bool isRough() const { return isCurrent() && isRough_; }

  /// Draws the layers above onto the kept scene with smooth edges, and shows the picture. The scene must be current.
  void drawLayersAbove();

 private:
  /// Tells whether the camera has moved or the window got another size since the scene was drawn, or none was.
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
  unsigned long cameraTime_ = 0;  // the time of the camera with which the last scene was drawn
  std::array<int, 2> size_{};     // the size of that picture
  bool isKeeping_ = true;
  bool isKept_ = false;
  bool isRough_ = false;  // what is kept is not smoothed
};

}  // namespace holdfast
