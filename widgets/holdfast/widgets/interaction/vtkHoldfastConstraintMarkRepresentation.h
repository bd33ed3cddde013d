#pragma once
/// Finds constraints by their marks in the picture.

#include <memory>
#include <optional>
#include <utility>

#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/mesh/section_plane.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Finds constraints by their marks in the picture. It draws nothing: `SceneContents` draw the marks.
class vtkHoldfastConstraintMarkRepresentation : public vtkWidgetRepresentation {
 public:
  static vtkHoldfastConstraintMarkRepresentation* New();
  vtkTypeMacro(vtkHoldfastConstraintMarkRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the marks that can be found. With null, the default, no mark is found.
  void SetMarks(std::shared_ptr<const holdfast::MarkSet> marks)
  {
    holdfast::assign(*this, this->Marks, std::move(marks));
  }

  /// Sets the surface that is drawn. Regions are then found by their faces, too. With null, the default, they are found
  /// by their marks only.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface) { this->Surface = std::move(surface); }

  /// Sets the section plane, which is copied. Marks whose places it cuts away are not found. With null, the default,
  /// there is no plane.
  void SetSection(const holdfast::SectionPlane* section);

  /// Sets how near to the cursor a mark is found, in pixels of a display of ordinary resolution. The default is 9.
  vtkSetClampMacro(ReachPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// Returns the constraint of the mark that is nearest to a pixel of the renderer's window, as a place in the list.
  /// The mark may be hidden by the surface. A mark of a single point comes before one of a region in the same place.
  /// Without a mark near the pixel, it returns the first region that has all corners of the face there. Without one it
  /// returns -1. O(marks).
  [[nodiscard]] holdfast::Index FindConstraint(double displayX, double displayY) const;

  /// Tells whether any mark is of this constraint. O(marks).
  [[nodiscard]] bool HasMarksOf(holdfast::Index constraint) const;

  void BuildRepresentation() override {}

 protected:
  vtkHoldfastConstraintMarkRepresentation() = default;
  ~vtkHoldfastConstraintMarkRepresentation() override = default;

 private:
  [[nodiscard]] holdfast::Index FindRegion(double displayX, double displayY) const;

  std::shared_ptr<const holdfast::MarkSet> Marks;
  std::shared_ptr<const holdfast::VisibleSurface> Surface;
  std::optional<holdfast::SectionPlane> Section;
  double ReachPixels = 9;
  double PixelRatio = 1;
};
