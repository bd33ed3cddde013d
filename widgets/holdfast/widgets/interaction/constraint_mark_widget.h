#pragma once
/// \file
/// Finds constraints by their marks: the one under the cursor, and the one that was clicked.

#include <memory>
#include <optional>

#include <vtkAbstractWidget.h>
#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/mesh/section_plane.h>

namespace holdfast {

class ConstraintMarkRepresentation : public vtkWidgetRepresentation {
 public:
  static ConstraintMarkRepresentation* New();
  vtkTypeMacro(ConstraintMarkRepresentation, vtkWidgetRepresentation)

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
  std::shared_ptr<const MarkSet> Marks;
  std::optional<SectionPlane> Section;
  double ReachPixels = 9;
  double PixelRatio = 1;
};

/// What a click has picked.
struct ConstraintPick {
  std::optional<Index> constraint;  ///< place in the list; none beside all marks
  bool isAdded = false;             ///< Shift or Ctrl was held: it joins, or leaves, what is selected
};

/// Watches the marks of constraints, and selects nothing by itself. A click is a press and a release within
/// `kClickPixels`; neither is aborted, so that a drag from the same place turns the picture.
///
/// | event          | when                                             | call data          |
/// |----------------|--------------------------------------------------|--------------------|
/// | HighlightEvent | the cursor is over another constraint, or none   | `Index*` or null   |
/// | PickEvent      | a click                                          | `ConstraintPick*`  |
///
/// Bindings, which the event translator can change: docs/widgets.md.
///
/// The second press of a double click begins none.
class ConstraintMarkWidget : public vtkAbstractWidget {
 public:
  static ConstraintMarkWidget* New();
  vtkTypeMacro(ConstraintMarkWidget, vtkAbstractWidget)

  void SetRepresentation(ConstraintMarkRepresentation* representation);
  [[nodiscard]] ConstraintMarkRepresentation* GetConstraintMarkRepresentation();
  void CreateDefaultRepresentation() override;
  /// Disabling ends what is highlighted.
  void SetEnabled(int enabling) override;

  /// What is watched; null: nothing. What is highlighted stays until the cursor moves, unless its constraint has no
  /// marks any more.
  void SetMarks(std::shared_ptr<const MarkSet> marks);
  void SetPixelRatio(double ratio) { this->GetConstraintMarkRepresentation()->SetPixelRatio(ratio); }

  /// The constraint under the cursor.
  [[nodiscard]] std::optional<Index> GetHighlighted() const { return this->Highlighted; }

 protected:
  ConstraintMarkWidget();
  ~ConstraintMarkWidget() override = default;

 private:
  void Hover();
  void Leave() { this->Highlight(std::nullopt); }
  void Press();
  void Release();

  [[nodiscard]] double PixelRatio() { return this->GetConstraintMarkRepresentation()->GetPixelRatio(); }
  [[nodiscard]] std::optional<Index> ConstraintAtCursor();
  void Highlight(std::optional<Index> constraint);

  Click LeftClick;
  std::optional<Index> Highlighted;
};

}  // namespace holdfast
