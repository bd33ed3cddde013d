#pragma once
/// Sprites are small shapes at places in space. They face the eye and keep their size in pixels whatever the camera
/// does.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <holdfast/numbers/types.h>
#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

/// The shapes of sprites.
enum class SpriteShape {
  Ball,    ///< shaded, as if it were round
  Bead,    ///< a disc on a bar, with a light rim
  Wedge,   ///< a filled triangle on its base, with a light rim and a light eye
  Hollow,  ///< a ring with a light inside and rim
  Ring     ///< a ring around whatever is there, with light rims
};

/// The part of sprites that is drawn.
enum class SpriteDepth {
  InFront,  ///< the part that nothing lies before
  Behind    ///< the part behind something else, faintly
};

/// One sprite: its place and its colour.
struct Sprite {
  Vector3 place;  ///< model units
  Color color;
};

/// Sprites of one shape and size, drawn by one actor.
///
///     PointSprites balls(SpriteShape::Ball);
///     balls.set({{Vector3(0, 0, 1), kAccentColor}});  // constraint_glyphs.h
///     balls.setPixels(12);
///     renderer->AddActor(&balls.actor());
class PointSprites {
 public:
  explicit PointSprites(SpriteShape shape, SpriteDepth depth = SpriteDepth::InFront);

  /// Shows `sprites` in place of all that there were. Of several in one place the last is seen. O(sprites).
  void set(const std::vector<Sprite>& sprites);

  /// Sets the diameter, in pixels of the window.
  void setPixels(double pixels) { actor_->GetProperty()->SetPointSize(static_cast<float>(pixels)); }

  [[nodiscard]] vtkActor& actor() const { return *actor_; }

 private:
  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> actor_;
};

/// Makes `actor` draw balls of one size and colour at some of the points of a mesh that is drawn. Nothing is copied
/// when the points move.
void showPointsAsBalls(vtkActor& actor, const Color& color);

}  // namespace holdfast
