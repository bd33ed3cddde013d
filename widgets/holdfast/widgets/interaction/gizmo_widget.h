#pragma once
/// \file
/// Lets the user drag the gizmo, or type how far.

#include <optional>

#include <vtkAbstractWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <holdfast/widgets/gizmo/gizmo_drag.h>
#include <holdfast/widgets/interaction/gizmo_representation.h>

namespace holdfast {

/// A part of the gizmo is active that is under the cursor or held, or has been chosen by a key or by `SetPart`. What is
/// chosen stays active until Escape, another choice, or the cursor on another part. A drag moves or turns along the
/// active part. It begins with a press on the part, or with a number that is typed: the gizmo then moves or turns by
/// exactly so much, and the mouse says no more. So "x 2.5 Return" moves by 2.5 along x. With Ctrl the mouse snaps
/// (gizmo_drag.h); angles count several turns.
///
/// Bindings, which the event translator can change: docs/widgets.md.
///
/// It aborts the events that it uses, those of the mouse over a part among them; all others pass, and so do characters
/// with Ctrl or Alt. The first move onto the gizmo passes too: other widgets learn by it that the cursor has left what
/// is theirs. It does not highlight while a button is down that was pressed beside it: that gesture belongs to others.
///
/// | event                  | when                                                            | call data      |
/// |------------------------|-----------------------------------------------------------------|----------------|
/// | HighlightEvent         | another part is active, or none                                 | `GizmoPart*`   |
/// | StartInteractionEvent  | a drag begins                                                   | none           |
/// | InteractionEvent       | the gizmo moved or turned, from where it stood before the drag  | `GizmoMotion*` |
/// | EndInteractionEvent    | the drag is over, and counts                                    | none           |
/// | CancelInteractionEvent | the gizmo stands where it stood before the drag, bit for bit    | none           |
///
/// After a drag the gizmo stands where the drag has moved it to; a turn leaves its axes as they were.
class GizmoWidget : public vtkAbstractWidget {
 public:
  static GizmoWidget* New();
  vtkTypeMacro(GizmoWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetRepresentation(GizmoRepresentation* representation) { this->SetWidgetRepresentation(representation); }
  [[nodiscard]] GizmoRepresentation* GetGizmoRepresentation();
  void CreateDefaultRepresentation() override;

  /// Disabling cancels a drag, and removes the gizmo from the window.
  void SetEnabled(int isEnabled) override;

  /// The active part, or `None`.
  [[nodiscard]] GizmoPart GetPart() { return this->GetGizmoRepresentation()->GetPart(); }
  /// Chooses a part, or none. Without effect during a drag, while disabled, and for a part that is not offered.
  void SetPart(GizmoPart part);

  [[nodiscard]] bool IsDragging() const { return this->Drag.has_value(); }
  /// Whether the mouse holds the part: else the drag is one of a number that is typed.
  [[nodiscard]] bool IsHeld() const { return this->Held; }

  /// Whether the widget would use a key without Ctrl and Alt: a character, or '\r' for Return, '\b' for Backspace, 27
  /// for Escape. For a window to ask before its shortcuts. While a number is typed the widget wants all keys, so that
  /// nothing else is edited before that is over.
  [[nodiscard]] bool WantsKey(char key);

  /// Ends a drag as a release does. To be called when the keyboard goes elsewhere while a number is typed.
  void Keep();
  /// Ends a drag as Escape does. What is chosen stays so.
  void Cancel();

 protected:
  GizmoWidget();
  ~GizmoWidget() override;

  void OnChar() override;

 private:
  // One for each widget event: whether the VTK event has been used.
  bool Hover();
  bool Leave();
  bool Press();
  bool Release();
  bool ChooseArrow() { return this->Choose(GizmoPart::ArrowX); }
  bool ChooseRing() { return this->Choose(GizmoPart::RingX); }
  bool Type();
  bool Correct();
  bool Complete();
  bool Reset();

  template <bool (GizmoWidget::*Action)()>
  static void Run(vtkAbstractWidget* widget);
  static void NoteButton(vtkObject* interactor, unsigned long event, void* self, void* callData);

  [[nodiscard]] DisplayPoint Cursor() const;
  [[nodiscard]] GizmoPart PartUnderCursor();
  bool Choose(GizmoPart ofX);
  void Highlight(GizmoPart part);
  void Grab();
  void FollowCursor();
  void FollowTyped();
  void MoveTo(GizmoMotion motion, const std::string& label);
  void EndDrag();

  std::optional<GizmoDrag> Drag;
  bool Held = false;
  bool Chosen = false;
  NumericInput Typed;
  vtkNew<vtkCallbackCommand> ButtonObserver;
  unsigned ButtonsDown = 0;  // a bit for each
};

}  // namespace holdfast
