#pragma once
/// \file
/// Tells over which constraint the cursor is, and which one was clicked.

#include <memory>
#include <optional>

#include <vtkAbstractWidget.h>

#include <holdfast/widgets/interaction/click.h>
#include <holdfast/widgets/interaction/constraint_mark_representation.h>

namespace holdfast {

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
/// | VTK event               | widget event               |                                     |
/// |-------------------------|----------------------------|-------------------------------------|
/// | MouseMoveEvent          | vtkWidgetEvent::Move       | looks for the mark under the cursor |
/// | LeaveEvent              | vtkWidgetEvent::HoverLeave | there is none                       |
/// | LeftButtonPressEvent    | vtkWidgetEvent::Select     | begins a click                      |
/// | LeftButtonReleaseEvent  | vtkWidgetEvent::EndSelect  | ends it                             |
///
/// The second press of a double click begins none.
class ConstraintMarkWidget : public vtkAbstractWidget {
 public:
  static ConstraintMarkWidget* New();
  vtkTypeMacro(ConstraintMarkWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
  ConstraintMarkWidget(const ConstraintMarkWidget&) = delete;
  void operator=(const ConstraintMarkWidget&) = delete;

  template <void (ConstraintMarkWidget::*Action)()>
  static void Call(vtkAbstractWidget* widget);
  void Hover();
  void Leave();
  void Press();
  void Release();

  [[nodiscard]] double PixelRatio() { return this->GetConstraintMarkRepresentation()->GetPixelRatio(); }
  [[nodiscard]] std::optional<Index> ConstraintAtCursor();
  void Highlight(std::optional<Index> constraint);

  Click LeftClick;
  std::optional<Index> Highlighted;
};

}  // namespace holdfast
