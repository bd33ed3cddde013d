#pragma once
/// \file
/// Constraints in a picture: a ball where each acts, in the colour of how it fared, and a line to where it wanted to
/// go.

#include <vector>

#include <vtkNew.h>

#include <holdfast/deform/deform.h>
#include <holdfast/view/color_map.h>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;

namespace holdfast {

/// One row of B in a picture.
struct ConstraintMark {
  Vector3 place;   ///< where the point is, model units
  Vector3 target;  ///< where it was to be
  ConstraintStatus status = ConstraintStatus::Met;
  bool isSinglePoint = false;  ///< of a constraint of type point or relative; else one of a selection
};

/// A mark for each row that has terms, in the order of rows. One of a rigid region lies at its vertex, one of a
/// relative constraint at the place that `from` names; both want to lie as they should to the other place. O(rows).
[[nodiscard]] std::vector<ConstraintMark> constraintMarks(const Model& model, const Deformation& deformation);

/// Dark for what is met, white for redundant, orange-red for conflicting, purple for missed: told apart by lightness as
/// well as by hue, on every colour of the map.
[[nodiscard]] Color glyphColor(ConstraintStatus status);

/// The actors of some marks. Balls and lines keep their size in pixels whatever the camera does; those of selections
/// and of targets that are not reached are smaller than those of single points.
class ConstraintGlyphs {
 public:
  explicit ConstraintGlyphs(std::vector<ConstraintMark> marks);
  ~ConstraintGlyphs();
  ConstraintGlyphs(const ConstraintGlyphs&) = delete;
  ConstraintGlyphs& operator=(const ConstraintGlyphs&) = delete;

  /// The diameter of a single point's ball, in pixels of the window; all other sizes follow.
  void setBallPixels(double pixels);

  /// All of them, in the order in which they are drawn.
  [[nodiscard]] std::vector<vtkActor*> actors() const;

 private:
  vtkNew<vtkActor> points_;
  vtkNew<vtkActor> selected_;
  vtkNew<vtkActor> lines_;
};

}  // namespace holdfast
