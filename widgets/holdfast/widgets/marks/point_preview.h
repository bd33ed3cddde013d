#pragma once
/// A preview shows the point of the surface that a click would take.

#include <optional>
#include <vector>

#include <holdfast/widgets/marks/constraint_glyphs.h>

namespace holdfast {

/// A point under the cursor: its place, and what it lies on, a vertex, an edge or a face.
struct PreviewedPoint {
  Vector3 place;  ///< model units
  MarkKind kind = MarkKind::Vertex;
};

/// The actors of one such point. A ring lies around the glyph that a constraint there would have.
class PointPreview {
 public:
  PointPreview() { set({}); }

  /// Shows `point`, or nothing where there is none.
  void set(const std::optional<PreviewedPoint>& point)
  {
    const bool isOnEdge = point && point->kind == MarkKind::Edge;
    const bool isInFace = point && point->kind == MarkKind::Face;
    const auto show = [&](PointSprites& sprites, bool isShown) {
      sprites.set(isShown ? std::vector<Sprite>{{point->place, kAccentColor}} : std::vector<Sprite>{});
    };
    show(bead_, isOnEdge);
    show(triangle_, isInFace);
    show(ball_, point && !isOnEdge && !isInFace);
    show(ring_, point.has_value());
  }

  /// Sets the diameter of the ball of a constraint's point, in pixels of the window.
  void setBallPixels(double pixels)
  {
    ball_.setPixels(0.8 * pixels);
    bead_.setPixels(1.4 * pixels);
    triangle_.setPixels(1.4 * pixels);
    ring_.setPixels(2.4 * pixels);
  }

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
