#pragma once
/// \file
/// What the examples of widgets are played on: a mesh in an offscreen window, a hand on the mouse, and a picture.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <holdfast/deform/deform.h>
#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/picking/visible_surface.h>
#include <holdfast/widgets/scene/scene_contents.h>

class vtkInteractorObserver;

namespace holdfast {

/// How many pixels of the window each pixel of a picture is the mean of, along both sides.
inline constexpr int kPixelRatio = 2;

/// Which files to show, and where to write to.
struct WidgetPicture {
  std::filesystem::path mesh;
  std::filesystem::path constraints;  ///< empty: the mesh at rest
  std::filesystem::path picture;
  bool isOff = false;  ///< widgets are switched off before their gestures
};

struct WidgetView {
  explicit WidgetView(WidgetPicture picture);

  /// The camera looks from this direction, as near as `radius` around the place fills the height.
  void lookAt(const Vector3& place, double radius, const Vector3& from) const;

  [[nodiscard]] Vector3 nearestVertex(const Vector3& place) const;
  /// The pixel of the window for one of the picture, both from the lower left; and that of a place.
  [[nodiscard]] static DisplayPoint pixelAt(double x, double y) { return kPixelRatio * DisplayPoint(x, y); }
  [[nodiscard]] DisplayPoint pixelOf(const Vector3& place) const;

  void send(unsigned long event, const DisplayPoint& pixel) const;
  /// With the left button, which stays down.
  void drag(const std::vector<DisplayPoint>& way) const;
  void release(const DisplayPoint& pixel) const;
  void click(const DisplayPoint& pixel) const;

  /// To be called between an example and its gesture.
  void switchOffWhereAsked(vtkInteractorObserver& widget) const;
  /// Writes what is shown now. Throws where that is not possible.
  void draw() const;

  WidgetPicture files;
  Model model;
  SceneContents scene;
  std::optional<DeformResult> deformation;
  std::shared_ptr<const VisibleSurface> surface;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
};

}  // namespace holdfast
