#pragma once
/// Finds constraints by their marks: the one under the cursor, and the one that was clicked.

#include <memory>
#include <optional>
#include <utility>

#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/mesh/section_plane.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

class ConstraintMarkRepresentation : public vtkWidgetRepresentation {
 public:
  static ConstraintMarkRepresentation* New();
  vtkTypeMacro(ConstraintMarkRepresentation, vtkWidgetRepresentation)

  /// Marks that can be found; null, the default: none.
  void SetMarks(std::shared_ptr<const MarkSet> marks) { assign(*this, this->Marks, std::move(marks)); }

  /// What is drawn: regions are found by its faces, too. Null, the default: by their marks only.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Surface = std::move(surface); }

  /// Marks whose places it cuts away are not found; none by default.
  void SetSection(const std::optional<SectionPlane>& section) { this->Section = section; }

  /// How near the cursor a mark is found, pixels of a display of ordinary resolution; 9 by default.
  vtkSetClampMacro(ReachPixels, double, 0.0, VTK_DOUBLE_MAX);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// The constraint, as a place in the list, of the nearest mark at a pixel of the renderer's window, hidden or not. A
  /// mark of a single point comes before one of a region in the same place. Without a mark near it, the first region
  /// that has all corners of the face there. O(marks).
  [[nodiscard]] std::optional<Index> FindConstraint(double displayX, double displayY) const;

  /// Whether any mark is of this constraint. O(marks).
  [[nodiscard]] bool HasMarksOf(Index constraint) const;

  void BuildRepresentation() override {}

 protected:
  ConstraintMarkRepresentation() = default;
  ~ConstraintMarkRepresentation() override = default;

 private:
  [[nodiscard]] std::optional<Index> FindRegion(double displayX, double displayY) const;

  std::shared_ptr<const MarkSet> Marks;
  std::shared_ptr<const VisibleSurface> Surface;
  std::optional<SectionPlane> Section;
  double ReachPixels = 9;
  double PixelRatio = 1;
};

/// The result of a click.
struct ConstraintPick {
  std::optional<Index> constraint;  ///< place in the list; none beside all marks
  bool isAdded = false;             ///< Shift or Ctrl was held: it joins or leaves the selection
};

/// Watches the marks of constraints, and selects nothing by itself. Clicks are as in `Click`; the second press of a
/// double click begins none.
class ConstraintMarkWidget : public WidgetOf<ConstraintMarkRepresentation> {
 public:
  static ConstraintMarkWidget* New();
  vtkTypeMacro(ConstraintMarkWidget, vtkAbstractWidget)

  [[nodiscard]] ConstraintMarkRepresentation* GetConstraintMarkRepresentation() { return &this->Drawn(); }

  /// Null: none. A highlighted constraint stays so until the cursor moves, or until it has no marks any more.
  void SetMarks(std::shared_ptr<const MarkSet> marks);
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Drawn().SetSurface(std::move(surface)); }
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }

  /// The constraint under the cursor.
  [[nodiscard]] std::optional<Index> GetHighlighted() const { return this->Highlighted; }

 protected:
  ConstraintMarkWidget();
  ~ConstraintMarkWidget() override = default;

 private:
  void Hover();
  void Leave() { this->Highlight(std::nullopt); }
  void Stop() override { this->Leave(); }
  void Release();

  [[nodiscard]] std::optional<Index> ConstraintAtCursor();
  void Highlight(std::optional<Index> constraint);

  std::optional<Index> Highlighted;
};

}  // namespace holdfast
