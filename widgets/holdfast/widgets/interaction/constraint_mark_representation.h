#pragma once
/// \file
/// Finds constraints by their marks in a picture. Draws nothing: glyphs are drawn elsewhere.

#include <memory>
#include <optional>

#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/mesh/section_plane.h>

namespace holdfast {

class ConstraintMarkRepresentation : public vtkWidgetRepresentation {
 public:
  static ConstraintMarkRepresentation* New();
  vtkTypeMacro(ConstraintMarkRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What can be found; null, the default: nothing.
  void SetMarks(std::shared_ptr<const MarkSet> marks);
  [[nodiscard]] const std::shared_ptr<const MarkSet>& GetMarks() const { return this->Marks; }

  /// Marks whose places it cuts away are not found; none by default.
  void SetSection(const std::optional<SectionPlane>& section) { this->Section = section; }
  [[nodiscard]] const std::optional<SectionPlane>& GetSection() const { return this->Section; }

  /// How near the cursor a mark is found, pixels of a display of ordinary resolution; 9 by default.
  vtkSetClampMacro(ReachPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ReachPixels, double);
  /// Pixels of the window for each of such a display; 1 by default.
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// The constraint, as a place in the list, of the nearest mark at a pixel of the renderer's window, hidden or not. A
  /// mark of a single point comes before one of a region in the same place. O(marks).
  [[nodiscard]] std::optional<Index> FindConstraint(double displayX, double displayY) const;

  /// Whether any mark is of this constraint. O(marks).
  [[nodiscard]] bool HasMarksOf(Index constraint) const;

  void BuildRepresentation() override {}

 protected:
  ConstraintMarkRepresentation() = default;
  ~ConstraintMarkRepresentation() override = default;

 private:
  ConstraintMarkRepresentation(const ConstraintMarkRepresentation&) = delete;
  void operator=(const ConstraintMarkRepresentation&) = delete;

  std::shared_ptr<const MarkSet> Marks;
  std::optional<SectionPlane> Section;
  double ReachPixels = 9;
  double PixelRatio = 1;
};

}  // namespace holdfast
