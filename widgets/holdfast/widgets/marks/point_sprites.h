#pragma once
/// Small shapes at places in space that face the eye and keep their size in pixels whatever the camera does.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <holdfast/base/types.h>
#include <holdfast/widgets/color/color_map.h>

namespace holdfast {

enum class SpriteShape {
  Ball,    ///< shaded, as if it were round
  Bead,    ///< a disc on a bar, with a light rim
  Wedge,   ///< a filled triangle on its base, with a light rim and a light eye
  Hollow,  ///< a ring with a light inside and rim
  Ring     ///< a ring around whatever is there, with light rims
};

/// Which part of sprites is drawn.
enum class SpriteDepth {
  InFront,  ///< what nothing lies before
  Behind    ///< what lies behind something else, faintly
};

struct Sprite {
  Vector3 place;  ///< model units
  Color color;
};

/// Sprites of one shape and size.
class PointSprites {
 public:
  explicit PointSprites(SpriteShape shape, SpriteDepth depth = SpriteDepth::InFront);

  /// In the place of all that there were; of several in one place the last is seen. O(sprites).
  void set(const std::vector<Sprite>& sprites);

  /// The diameter, in pixels of the window.
  void setPixels(double pixels) { actor_->GetProperty()->SetPointSize(static_cast<float>(pixels)); }

  [[nodiscard]] vtkActor& actor() const { return *actor_; }

 private:
  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> actor_;
};

/// Balls of one size and colour at some of the points of a mesh that is drawn: nothing is copied when these move.
void showPointsAsBalls(vtkActor& actor, const Color& color);

}  // namespace holdfast
