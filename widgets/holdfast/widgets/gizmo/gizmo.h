#pragma once
/// \file
/// The handle that a user drags: three arrows, three squares, three rings, a ring about them and a ball in the middle.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <holdfast/widgets/gizmo/gizmo_part_actors.h>
#include <holdfast/widgets/gizmo/gizmo_trace.h>

class vtkCoordinate;
class vtkRenderer;
class vtkTextActor;

namespace holdfast {

/// The radius of the outer ring unless something else is said, in pixels of the window.
inline constexpr double kGizmoPixels = 115;

/// What the gizmo offers: points move, and have nothing to turn.
enum class GizmoMotions { Moves, MovesAndTurns };

/// Arrows move along an axis, squares across one, the ball across the view; rings turn about an axis, the outer one
/// about the view direction. Drawn over everything, in a layer of its own. It has the same size on the display at any
/// distance. What is seen from the end or the edge fades out and cannot be grabbed.
class Gizmo {
 public:
  /// Shown, at the origin.
  Gizmo();
  ~Gizmo();
  Gizmo(const Gizmo&) = delete;
  Gizmo& operator=(const Gizmo&) = delete;

  /// Puts everything into `layer`: a renderer of a higher layer than the scene's, in the same window, for this alone.
  /// Its camera and its lights are the gizmo's from now on.
  void addTo(vtkRenderer& layer);

  /// The columns of `axes` are orthonormal and right-handed: the axes of the handle, of the world or of the view.
  void setFrame(const Vector3& center, const Eigen::Matrix3d& axes);
  [[nodiscard]] const GizmoFrame& frame() const noexcept { return frame_; }

  /// The radius of the outer ring in pixels of the window; widths, tolerances and texts follow.
  void setPixelSize(double radius);
  [[nodiscard]] double pixelSize() const noexcept { return pixels_; }
  /// That of the other rings: what `GizmoDrag` wants to know.
  [[nodiscard]] double ringPixels() const noexcept { return gizmo_layout::kRingRadius * pixels_; }

  void show(GizmoMotions motions = GizmoMotions::MovesAndTurns);
  void hide();
  [[nodiscard]] bool isShown() const noexcept { return isShown_; }

  /// The part that is drawn in yellow, also where it is seen from the end: the one under the cursor, or `None`.
  void highlight(GizmoPart part);
  [[nodiscard]] GizmoPart highlighted() const noexcept { return highlighted_; }

  /// Until `endDrag` only the part of `trace` is drawn, where the frame is now, and what the trace says.
  void showDrag(GizmoTrace trace);
  void endDrag();
  [[nodiscard]] bool isDragging() const noexcept { return drag_.has_value(); }

  /// Follows the camera of `scene`: to be called before each time that the window is rendered. About a millisecond.
  void update(vtkRenderer& scene);

  /// The part at a place of the display, in pixels from the window's lower left corner, or `None`; see `hitGizmo`.
  [[nodiscard]] GizmoPart hitTest(vtkRenderer& scene, double displayX, double displayY) const;

  /// All of them, in the order in which they are drawn.
  [[nodiscard]] std::vector<vtkProp*> props() const;

 private:
  void followCamera(vtkRenderer& scene);
  void updateLetters(const GizmoPlacement& placement, const ViewGeometry& view);
  void updateTrace(const GizmoPlacement& placement);
  [[nodiscard]] bool isOffered(GizmoPart part) const;
  [[nodiscard]] bool isDrawn(GizmoPart part) const;
  [[nodiscard]] Color colorOf(GizmoPart part) const;

  GizmoFrame frame_;
  double pixels_ = kGizmoPixels;
  bool isShown_ = true;
  GizmoMotions motions_ = GizmoMotions::MovesAndTurns;
  GizmoPart highlighted_ = GizmoPart::None;
  std::optional<GizmoTrace> drag_;
  std::vector<std::unique_ptr<GizmoPartActors>> parts_;  // one for each but `None`, in their order
  std::array<vtkNew<vtkTextActor>, 3> letters_;
  std::array<vtkNew<vtkCoordinate>, 3> letterPlaces_;
  GizmoTraceActors trace_;
  vtkSmartPointer<vtkRenderer> layer_;
};

}  // namespace holdfast
