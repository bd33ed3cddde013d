#pragma once
/// \file
/// Finds constraints by their marks in a picture. Draws nothing: glyphs are drawn elsewhere.

#include <optional>
#include <vector>

#include <vtkWidgetRepresentation.h>

#include <holdfast/view/constraint_marks.h>

namespace holdfast {

class ConstraintMarkRepresentation : public vtkWidgetRepresentation {
 public:
  static ConstraintMarkRepresentation* New();
  vtkTypeMacro(ConstraintMarkRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What can be found; none by default.
  void SetMarks(std::vector<ConstraintMark> marks);
  [[nodiscard]] const std::vector<ConstraintMark>& GetMarks() const { return this->Marks; }

  /// How near the cursor a mark is found, pixels of a display of ordinary resolution; 9 by default.
  vtkSetClampMacro(ReachPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ReachPixels, double);
  /// Pixels of the window for each of such a display; 1 by default.
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// The constraint, as a place in the list, of the nearest mark at a pixel of the renderer's window, hidden or not. A
  /// mark of a single point comes before one of a region in the same place. O(marks).
  [[nodiscard]] std::optional<Index> FindConstraint(double displayX, double displayY) const;

  void BuildRepresentation() override {}

 protected:
  ConstraintMarkRepresentation() = default;
  ~ConstraintMarkRepresentation() override = default;

 private:
  ConstraintMarkRepresentation(const ConstraintMarkRepresentation&) = delete;
  void operator=(const ConstraintMarkRepresentation&) = delete;

  std::vector<ConstraintMark> Marks;
  double ReachPixels = 9;
  double PixelRatio = 1;
};

}  // namespace holdfast
