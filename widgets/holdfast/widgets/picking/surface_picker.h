#pragma once
/// The point of the surface under the cursor.

#include <memory>
#include <optional>
#include <utility>

#include <vtkRenderer.h>

#include <holdfast/surface/surface_location.h>
#include <holdfast/surface/surface_point.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// What a click may pick.
enum class PickKind {
  Nearest,  ///< a vertex near the cursor, or else an edge, or else the point of the face
  Vertex,
  Edge,
  Face
};

/// A visible point of the surface.
struct SurfacePick {
  /// `AtVertex`, `AtEdge` of an edge of a face, its smaller vertex first, or `AtFace`. Weights and t lie in [0, 1];
  /// weights sum to 1 within 1e-15.
  SurfaceLocation location;
  Vector3 place = Vector3::Zero();  ///< of the location at the present positions, model units
  Index face = 0;                   ///< the point lies on it: the face under the cursor wherever possible
  Index triangle = 0;               ///< the same of the triangles of the model's triangulation
};

/// The canonical form of the location of a pick, or of another that `mesh` has and that is not `AtNear`.
[[nodiscard]] SurfacePoint pointOf(const SurfaceLocation& location, const Mesh& mesh);

/// Picks points of a surface. Sees it from both sides, and only what nothing hides and no section cuts away.
class SurfacePicker {
 public:
  /// `surface` is not null.
  explicit SurfacePicker(std::shared_ptr<const VisibleSurface> surface) : surface_(std::move(surface)) {}

  /// What is under the cursor, which is at the pixel (`displayX`, `displayY`) of the renderer's window, counted from
  /// the lower left; the point meant is the pixel's center. Distances are those on the screen.
  /// - `Face`: the point of the front-most face there.
  /// - `Vertex`, `Edge`: the nearest visible vertex, or the nearest point of an edge where that is visible, within
  ///   `snapPixels`; else of the front-most face there and of the faces that touch it, at any distance.
  /// - `Nearest`: the vertex within `snapPixels`, if there is one; else the point of an edge, likewise; else that of
  ///   the face.
  /// Where there is no face under the cursor, a vertex or an edge still counts within `snapPixels`. Nothing where there
  /// is no such point. About O(log T) and what is shown within `snapPixels`, hidden or not.
  [[nodiscard]] std::optional<SurfacePick> pick(vtkRenderer& renderer, double displayX, double displayY, PickKind kind,
                                                double snapPixels) const;

  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& surface() const noexcept { return surface_; }

 private:
  std::shared_ptr<const VisibleSurface> surface_;
};

}  // namespace holdfast
