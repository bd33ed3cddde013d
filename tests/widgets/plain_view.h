#pragma once
/// \file
/// How a camera shows a mesh, worked out from the camera's parameters and by looking at every triangle, with none of
/// the code under test.

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <vtkNew.h>

#include <holdfast/mesh/triangulation.h>

class vtkCamera;
class vtkRenderer;
class vtkRenderWindow;

namespace holdfast::test {

enum class Projection { Perspective, Parallel };

/// A camera that looks from `eye` at `target`, y to the top.
struct PlainView {
  Vector3 eye{0, 0, 10};
  Vector3 target{0, 0, 0};
  Projection projection = Projection::Perspective;
  int width = 400;
  int height = 300;

  /// Place of the screen, from the lower left of the picture; depth before the eye.
  [[nodiscard]] Vector3 shown(const Vector3& place) const;
  /// Pixels for a unit of length at this depth.
  [[nodiscard]] double pixelsAt(double depth) const;
  /// Returns the place of the line of sight through a point of the screen at `depth`.
  [[nodiscard]] Vector3 placeAt(const Eigen::Vector2d& point, double depth) const;
};

/// Moves a camera there.
void look(vtkCamera& camera, const PlainView& view);

/// A renderer in a window that is never shown, with that camera.
class PlainScreen {
 public:
  explicit PlainScreen(const PlainView& view);
  ~PlainScreen();
  PlainScreen(const PlainScreen&) = delete;
  PlainScreen& operator=(const PlainScreen&) = delete;

  [[nodiscard]] vtkRenderer& renderer() const { return *renderer_; }
  void look(const PlainView& view);

 private:
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
};

/// A point of a triangle on a line of sight.
struct PlainSight {
  Index triangle = -1;  ///< -1 for nothing
  Vector3 weights = Vector3::Zero();
  bool isDoubtful = false;  ///< rounding decides
};

/// The first triangle on the line of sight through a point of the screen. O(T).
[[nodiscard]] PlainSight plainSight(const PlainView& view, const Eigen::Vector2d& point, const Positions& positions,
                                    const std::vector<Triangle>& triangles);

/// Tells whether a triangle that has not all of `own` as corners lies before `place`; nothing where rounding decides.
/// O(T).
[[nodiscard]] std::optional<bool> isPlainlyVisible(const PlainView& view, const Vector3& place,
                                                   const std::vector<Index>& own, const Positions& positions,
                                                   const std::vector<Triangle>& triangles);

}  // namespace holdfast::test
