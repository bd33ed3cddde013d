#pragma once
/// A picker finds the point of the surface under the cursor.

#include <memory>
#include <optional>
#include <utility>

#include <vtkRenderer.h>

#include <holdfast/surface/surface_location.h>
#include <holdfast/surface/surface_point.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// The kinds of points that a click may pick.
enum class PickKind {
  Nearest,  ///< a vertex near the cursor, or else an edge, or else the point of the face
  Vertex,
  Edge,
  Face
};

/// A visible point of the surface.
struct SurfacePick {
  /// The location is `AtVertex`, `AtEdge` or `AtFace`. An `AtEdge` is an edge of a face and names its smaller vertex
  /// first. Weights and t lie in [0, 1]. Weights sum to 1 within 1e-15.
  SurfaceLocation location;
  Vector3 place = Vector3::Zero();  ///< the place of the location at the present positions, model units
  /// The face on which the point lies. It is the face under the cursor wherever possible.
  Index face = 0;
  /// The triangle of the model's triangulation on which the point lies. It is the one under the cursor wherever
  /// possible.
  Index triangle = 0;
};

/// Returns the canonical form of a location. The location comes from a pick, or is another one that `mesh` has and that
/// is not `AtNear`.
[[nodiscard]] SurfacePoint pointOf(const SurfaceLocation& location, const Mesh& mesh);

/// Picks points of a surface. It sees the surface from both sides, and only what nothing hides and no section cuts
/// away.
///
///     const SurfacePicker picker(std::make_shared<const VisibleSurface>(model));
///     const auto pick = picker.pick(*renderer, x, y, PickKind::Nearest, 7);
///     if (pick) list.constraints.push_back({"tip", true, PointConstraint{pick->location, Target{pick->place}}});
class SurfacePicker {
 public:
  /// Picks on `surface`, which is not null.
  explicit SurfacePicker(std::shared_ptr<const VisibleSurface> surface) : surface_(std::move(surface)) {}

  /// Returns the point under the cursor. The cursor is at the pixel (`displayX`, `displayY`) of the renderer's window,
  /// counted from the lower left. The point meant is the centre of the pixel. Distances are those on the screen.
  /// - `Face` picks the point of the front-most face there.
  /// - `Vertex` picks the nearest visible vertex within `snapPixels`.
  /// - `Edge` picks the nearest point of an edge within `snapPixels`, where that point is visible.
  /// - Where `Vertex` or `Edge` finds none so near, it looks at any distance. It then picks from the front-most face
  ///   there and the faces that touch it.
  /// - `Nearest` picks the vertex within `snapPixels`, if there is one. Else it picks the point of an edge within
  ///   `snapPixels`, and else that of the face.
  ///
  /// Where there is no face under the cursor, a vertex or an edge still counts within `snapPixels`. Where there is no
  /// such point, the result is empty. The cost is about O(log T) and what is shown within `snapPixels`, hidden or not.
  [[nodiscard]] std::optional<SurfacePick> pick(vtkRenderer& renderer, double displayX, double displayY, PickKind kind,
                                                double snapPixels) const;

  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& surface() const noexcept { return surface_; }

 private:
  std::shared_ptr<const VisibleSurface> surface_;
};

}  // namespace holdfast
