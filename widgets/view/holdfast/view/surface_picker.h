#pragma once
/// \file
/// The point of the surface under the cursor.

#include <optional>
#include <vector>

#include <holdfast/surface/surface_location.h>
#include <holdfast/view/visible_surface.h>

class vtkRenderer;

namespace holdfast {

/// What a click may name.
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

/// Picks points of one model. Sees the surface from both sides, and only what nothing hides.
class SurfacePicker {
 public:
  /// At rest. `model` stays alive as long as this. Costs nothing before the first pick, which makes the search tree in
  /// O(T log T).
  explicit SurfacePicker(const Model& model) : model_(model), positions_(model.mesh.positions) {}

  /// Moves the surface: one row for each vertex of the file, all finite. O(N); the next pick costs O(T) more.
  void setPositions(const Positions& positions);

  /// What is under the cursor, which is at the pixel (`displayX`, `displayY`) of the renderer's window, counted from
  /// the lower left; the point meant is the pixel's centre. Distances are those on the screen.
  /// - `Face`: the point of the front-most face there.
  /// - `Vertex`, `Edge`: the nearest visible vertex, or the nearest point of an edge where that is visible, within
  ///   `snapPixels`; else of the front-most face there and of the faces that touch it, at any distance.
  /// - `Nearest`: the vertex within `snapPixels`, if there is one; else the point of an edge, likewise; else that of
  /// the
  ///   face.
  /// Where there is no face under the cursor, a vertex or an edge still counts within `snapPixels`. Nothing where there
  /// is no such point. About O(log T) and what is shown within `snapPixels`, hidden or not.
  [[nodiscard]] std::optional<SurfacePick> pick(vtkRenderer& renderer, double displayX, double displayY, PickKind kind,
                                                double snapPixels);

  /// The surface at the present positions, ready for rays.
  [[nodiscard]] const VisibleSurface& surface();
  [[nodiscard]] const Model& model() const noexcept { return model_; }

 private:
  const Model& model_;
  Positions positions_;
  bool isStale_ = false;  // the surface is not yet at `positions_`
  std::optional<VisibleSurface> surface_;
};

}  // namespace holdfast
