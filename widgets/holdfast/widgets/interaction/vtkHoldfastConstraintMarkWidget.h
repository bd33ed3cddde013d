#pragma once
/// Reports the constraint under the cursor, and the one that was clicked.

#include <memory>
#include <utility>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastConstraintMarkRepresentation.h>
#include <holdfast/widgets/marks/mark_set.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// The call data of `PickEvent`: what a click has chosen.
struct ConstraintPick {
  Index constraint = -1;  ///< place in the list; -1 where the click was beside all constraints
  bool isAdded = false;   ///< Shift or Ctrl was held: the constraint is to join or leave the selection
};

}  // namespace holdfast

/// Reports the constraint under the cursor and the one that was clicked. It selects nothing and draws nothing itself. A
/// click is as `Click` describes. The second press of a double click begins no click.
///
///     vtkNew<vtkHoldfastConstraintMarkWidget> marks;
///     marks->SetInteractor(interactor);
///     marks->SetMarks(scene.sharedMarks());  // `scene` is a `SceneContents`
///     marks->AddObserver(vtkCommand::HighlightEvent, &tool, &Tool::highlight);  // call data: `Index*`, or null
///     marks->AddObserver(vtkCommand::PickEvent, &tool, &Tool::pick);            // call data: `ConstraintPick*`
///     marks->On();
///
/// These are the bindings, each with its widget event:
///
///     MouseMoveEvent           Move: highlights the constraint under the cursor
///     LeaveEvent               HoverLeave: highlights none
///     LeftButtonPressEvent     Select: begins a click
///     LeftButtonReleaseEvent   EndSelect: ends the click, and reports it; with Shift or Ctrl it has `isAdded`
///
/// These are the events that it invokes:
///
///     HighlightEvent           another constraint is under the cursor; call data: `Index*`, or null for none
///     PickEvent                a click, also beside all constraints; call data: `ConstraintPick*`
class vtkHoldfastConstraintMarkWidget : public holdfast::WidgetOf<vtkHoldfastConstraintMarkRepresentation> {
 public:
  static vtkHoldfastConstraintMarkWidget* New();
  vtkTypeMacro(vtkHoldfastConstraintMarkWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] vtkHoldfastConstraintMarkRepresentation* GetConstraintMarkRepresentation() { return &this->Drawn(); }

  /// Sets the marks that can be found; with null there are none. A highlighted constraint stays so until the cursor
  /// moves, or until it has no marks any more.
  void SetMarks(std::shared_ptr<const holdfast::MarkSet> marks);
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface)
  {
    this->Drawn().SetSurface(std::move(surface));
  }
  void SetPixelRatio(double ratio) { this->Drawn().SetPixelRatio(ratio); }

  /// Returns the constraint that is highlighted because it is under the cursor; -1 where there is none.
  [[nodiscard]] holdfast::Index GetHighlighted() const { return this->Highlighted; }

 protected:
  vtkHoldfastConstraintMarkWidget();
  ~vtkHoldfastConstraintMarkWidget() override = default;

 private:
  void Hover();
  void Leave() { this->Highlight(-1); }
  void Stop() override { this->Leave(); }
  void Release();

  [[nodiscard]] holdfast::Index ConstraintAtCursor();
  void Highlight(holdfast::Index constraint);

  holdfast::Index Highlighted = -1;
};
