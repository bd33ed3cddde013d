#pragma once
/// Lets the user drag the gizmo, or type how far it moves.

#include <optional>
#include <string>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <holdfast/widgets/gizmo/gizmo_drag.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>

/// Moves and rotates an object by arrows, squares and rings, or by a typed number. The active part is the one under the
/// cursor, or the one that a key or `SetPart` has chosen. A chosen part stays active until Escape, another choice, or
/// the cursor on another part.
///
///     vtkNew<vtkHoldfastGizmoWidget> gizmo;
///     gizmo->SetInteractor(interactor);
///     gizmo->GetGizmoRepresentation()->SetFrame(place, Eigen::Matrix3d::Identity());
///     gizmo->AddObserver(vtkCommand::InteractionEvent, &tool, &Tool::drag);  // call data: `GizmoMotion*`
///     gizmo->On();
///
/// A drag along the active part begins with a press, or with a typed number. A typed number moves or rotates the gizmo
/// by exactly that amount, and the mouse has no effect then. "x 2.5 Return" moves it by 2.5 along x. With Ctrl the
/// mouse snaps (gizmo_drag.h). Angles count several turns. After a drag the gizmo stays at its new place. A rotation
/// does not change its axes.
///
/// These are the bindings, each with its widget event:
///
///     MouseMoveEvent                              Move: highlights the part under the cursor, or drags the part held
///     LeaveEvent                                  HoverLeave: highlights no part, unless one is chosen or dragged
///     LeftButtonPressEvent, -DoubleClickEvent     Select: begins a drag of the part under the cursor; ends a typed one
///     LeftButtonReleaseEvent                      EndSelect: ends the drag
///     KeyPressEvent x, y, z                       Translate: chooses an arrow
///     KeyPressEvent x, y, z with Shift            Rotate: chooses a ring
///     KeyPressEvent of a digit, "." "," "-"       ModifyEvent: types a number for the active part
///     KeyPressEvent BackSpace                     Delete: takes back the last key of the number
///     KeyPressEvent Return, KP_Enter              Completed: ends the drag of a typed number
///     KeyPressEvent Escape                        Reset: takes back the drag, and the choice of a part
///
/// These are the events that it invokes:
///
///     HighlightEvent            another part is active, or none; call data: `GizmoPart*`
///     StartInteractionEvent     a drag begins
///     InteractionEvent          it moved or rotated; call data: `GizmoMotion*`, from where it stood before the drag
///     EndInteractionEvent       a drag ends, and counts
///     CancelInteractionEvent    a drag was taken back: the gizmo stands where it stood before
///
/// The widget aborts the events that it uses. These include mouse events over a part. Two kinds of events pass:
/// characters with Ctrl or Alt, and the first move onto the gizmo. By that move other widgets learn that the cursor has
/// left them. The widget does not highlight while a button is down that was pressed beside it.
class vtkHoldfastGizmoWidget : public holdfast::WidgetOf<vtkHoldfastGizmoRepresentation> {
 public:
  static vtkHoldfastGizmoWidget* New();
  vtkTypeMacro(vtkHoldfastGizmoWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] vtkHoldfastGizmoRepresentation* GetGizmoRepresentation() { return &this->Drawn(); }
  /// Enables or disables the widget. Disabling cancels a drag and removes the gizmo from the window.
  void SetEnabled(int isEnabled) override;

  [[nodiscard]] holdfast::GizmoPart GetPart() { return this->Drawn().GetPart(); }
  /// Chooses a part; `None` chooses none. The call has no effect during a drag, while the widget is disabled, and for a
  /// part that is not offered.
  void SetPart(holdfast::GizmoPart part);

  [[nodiscard]] bool IsDragging() const { return this->Drag.has_value(); }
  /// Tells whether the mouse holds the part. A drag that is not held is that of a typed number.
  [[nodiscard]] bool IsHeld() const { return this->Held; }

  /// Tells whether the widget would use a key without Ctrl and Alt. `key` is a character, or '\r' for Return, '\b' for
  /// Backspace, 27 for Escape. A window asks this before its shortcuts. While a number is typed the widget uses all
  /// keys.
  [[nodiscard]] bool WantsKey(char key);

  /// Ends a drag as a release does. Call it when the widget loses the keyboard while a number is typed.
  void Keep();
  /// Ends a drag as Escape does. A chosen part stays chosen.
  void Cancel();

 protected:
  vtkHoldfastGizmoWidget();
  ~vtkHoldfastGizmoWidget() override { this->vtkHoldfastGizmoWidget::SetEnabled(0); }

  void OnChar() override;

 private:
  // There is one for each widget event. It returns whether it has used the VTK event.
  bool Hover();
  void Leave();
  bool Press();
  bool Release();
  bool ChooseArrow() { return this->Choose(holdfast::GizmoPart::ArrowX); }
  bool ChooseRing() { return this->Choose(holdfast::GizmoPart::RingX); }
  bool Type();
  bool Correct();
  bool Complete();
  bool Reset();

  static void NoteButton(vtkObject* interactor, unsigned long event, void* self, void* callData);

  [[nodiscard]] holdfast::DisplayPoint PixelCenter() const
  {
    return holdfast::centerOfPixel(this->Cursor().x(), this->Cursor().y());
  }
  [[nodiscard]] holdfast::GizmoPart PartUnderCursor()
  {
    return static_cast<holdfast::GizmoPart>(holdfast::stateAtCursor(*this->WidgetRep, *this->Interactor));
  }
  bool Choose(holdfast::GizmoPart ofX);
  void Highlight(holdfast::GizmoPart part);
  void Grab();
  void FollowCursor();
  void FollowTyped();
  void MoveTo(holdfast::GizmoMotion motion, const std::string& label);
  void EndDrag();

  std::optional<holdfast::GizmoDrag> Drag;
  bool Held = false;
  bool Chosen = false;
  holdfast::NumericInput Typed;
  vtkNew<vtkCallbackCommand> ButtonObserver;
  unsigned ButtonsDown = 0;  // a bit for each
};
