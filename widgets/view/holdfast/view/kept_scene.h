#pragma once
/// \file
/// Drawing what follows the cursor again without the scene under it.

#include <vtkNew.h>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace holdfast {

/// Keeps colours and depths of a scene each time that it is drawn, so that layers above it can be drawn anew onto the
/// same scene. A picture from `drawLayersAbove` is the one that drawing everything would give, pixel for
/// pixel.
class KeptScene {
 public:
  /// The layers from that of `scene` to that of `last`, which may be the same one; no other renderer is in the layer of
  /// `last`. Both are in a window without multisampling, which stays alive as long as this.
  KeptScene(vtkRenderer& scene, vtkRenderer& last);
  ~KeptScene();
  KeptScene(const KeptScene&) = delete;
  KeptScene& operator=(const KeptScene&) = delete;

  /// Whether a scene is kept that the renderer's camera has not left since, in a window of the same size.
  [[nodiscard]] bool isCurrent() const;

  /// Draws the layers above onto the kept scene, and shows the picture. The scene is current.
  void drawLayersAbove();

 private:
  void keep();
  void putBack();
  void copy(vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to);

  vtkRenderer& scene_;
  vtkRenderer& last_;
  vtkOpenGLRenderWindow& window_;
  vtkNew<vtkOpenGLFramebufferObject> kept_;
  unsigned long observer_ = 0;
  unsigned long cameraTime_ = 0;  // of the kept scene's camera
  bool isKept_ = false;
};

}  // namespace holdfast
