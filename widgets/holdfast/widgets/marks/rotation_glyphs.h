#pragma once
/// The rotation field as arrows: each along the axis about which the surface rotates there.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <holdfast/deform/model.h>

namespace holdfast {

/// About how many arrows there are at the most.
inline constexpr Index kRotationArrows = 400;

/// The surface rotates counterclockwise, seen against the arrow.
struct RotationArrow {
  Index vertex = 0;  ///< of the file
  Vector3 tail;      ///< where that is, model units
  Vector3 along;     ///< the whole of it, model units
};

/// Arrows at `vertices` of the file, at `positions`, along the axes of the logs `q` of all unknowns. 90 degrees, or the
/// largest angle where that is more, has the length `longest`; angles of less than half a degree have no arrow.
[[nodiscard]] std::vector<RotationArrow> rotationArrows(const Model& model, const std::vector<Index>& vertices,
                                                        const Positions& positions, const Columns3& q, double longest);

/// The actors of such arrows, dark with a light outline, readable on every colour; a surface hides them.
class RotationGlyphs {
 public:
  /// `model` stays alive as long as this.
  explicit RotationGlyphs(const Model& model);

  /// Shows the field `q`, one row for each unknown, on the mesh at `positions`; no rows: no arrows. O(N) at first.
  void set(const Positions& positions, const Columns3& q);

  /// Without arrows at vertices of the file for which `isHidden`; empty: with all. For the next `set`.
  void setHidden(std::vector<char> isHidden) { isHidden_ = std::move(isHidden); }

  /// In the order in which they are drawn.
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
