#pragma once
/// The point of the surface that a click would take.

#include <optional>
#include <vector>

#include <vtkActor.h>

#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/marks/point_sprites.h>

namespace holdfast {

/// A point under the cursor: its place, and whether it lies on a vertex, on an edge or in a face.
struct PreviewedPoint {
  Vector3 place;  ///< model units
  MarkKind kind = MarkKind::Vertex;
};

/// The actors of one such point: a ring around the glyph that a constraint there would have.
class PointPreview {
 public:
  PointPreview() { set({}); }

  void set(const std::optional<PreviewedPoint>& point);

  /// The diameter of the ball of a constraint's point, in pixels of the window.
  void setBallPixels(double pixels);

  [[nodiscard]] std::vector<vtkActor*> actors() const
  {
    return {&ball_.actor(), &bead_.actor(), &triangle_.actor(), &ring_.actor()};
  }

 private:
  PointSprites ball_{SpriteShape::Ball};
  PointSprites bead_{SpriteShape::Bead};
  PointSprites triangle_{SpriteShape::Wedge};
  PointSprites ring_{SpriteShape::Ring};
};

}  // namespace holdfast
