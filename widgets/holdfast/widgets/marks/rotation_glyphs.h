#pragma once
/// Arrows show the rotation field. Each lies along the axis about which the surface rotates there.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/deform/model.h>

namespace holdfast {

/// About so many arrows are drawn at the most.
inline constexpr Index kRotationArrows = 400;

/// One arrow. Seen against the arrow, the surface rotates counterclockwise.
struct RotationArrow {
  Index vertex = 0;  ///< the vertex of the file
  Vector3 tail;      ///< the place of the vertex, model units
  Vector3 along;     ///< the way from tail to head, model units
};

/// Makes arrows at `vertices` of the file, which lie at `positions`. The arrows lie along the axes of the logs `q`, one
/// row for each unknown. An arrow has the length `longest` for 90 degrees, or for the largest angle where that is more.
/// Angles of less than half a degree have no arrow.
[[nodiscard]] std::vector<RotationArrow> rotationArrows(const Model& model, const std::vector<Index>& vertices,
                                                        const Positions& positions, const Columns3& q, double longest);

/// The actors of such arrows. They are dark with a light outline, so they are readable on every colour. A surface hides
/// them.
class RotationGlyphs {
 public:
  /// Makes the actors without arrows. `model` must stay alive as long as the glyphs.
  explicit RotationGlyphs(const Model& model);

  /// Shows the field `q`, one row for each unknown, on the mesh at `positions`. Without rows there are no arrows. O(N)
  /// at first.
  void set(const Positions& positions, const Columns3& q);

  /// Leaves out arrows at vertices of the file for which `isHidden` holds. An empty vector leaves out none. It takes
  /// effect at the next `set`.
  void setHidden(std::vector<char> isHidden) { isHidden_ = std::move(isHidden); }

  /// Returns the actors in the order in which they are drawn.
  [[nodiscard]] std::vector<vtkActor*> actors() const { return {outlines_, arrows_}; }

 private:
  const Model& model_;
  std::vector<Index> vertices_;  // evenly spread at rest, of those that faces use
  std::vector<char> isHidden_;
  vtkNew<vtkPolyData> arrowData_;
  vtkNew<vtkPolyData> outlineData_;
  vtkNew<vtkActor> arrows_;
  vtkNew<vtkActor> outlines_;
};

}  // namespace holdfast
