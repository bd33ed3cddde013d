#pragma once
/// Lets the user drag the gizmo, or type how far.

#include <optional>

#include <vtkNew.h>

#include <holdfast/widgets/gizmo/gizmo_drag.h>
#include <holdfast/widgets/interaction/gizmo_representation.h>
#include <holdfast/widgets/interaction/interaction_events.h>

namespace holdfast {

/// The active part is the one under the cursor, or the one that a key or `SetPart` has chosen, until Escape, another
/// choice, or the cursor on another part. A drag along it begins with a press, or with a typed number: then the gizmo
/// moves or rotates by exactly that amount, and the mouse has no effect. "x 2.5 Return" moves by 2.5 along x. With Ctrl
/// the mouse snaps (gizmo_drag.h); angles count several turns.
///
/// It aborts the events that it uses, with those of the mouse over a part; characters with Ctrl or Alt pass, and so
/// does the first move onto the gizmo, by which other widgets learn that the cursor has left them. It does not
/// highlight while a button is down that was pressed beside it.
///
/// After a drag the gizmo stays at its new place; a rotation does not change its axes.
class GizmoWidget : public WidgetOf<GizmoRepresentation> {
 public:
  static GizmoWidget* New();
  vtkTypeMacro(GizmoWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] GizmoRepresentation* GetGizmoRepresentation() { return &this->Drawn(); }
  /// Disabling cancels a drag, and removes the gizmo from the window.
  void SetEnabled(int isEnabled) override;

  /// The active part, or `None`.
  [[nodiscard]] GizmoPart GetPart() { return this->Drawn().GetPart(); }
  /// Chooses a part, or none. Without effect during a drag, while disabled, and for a part that is not offered.
  void SetPart(GizmoPart part);

  [[nodiscard]] bool IsDragging() const { return this->Drag.has_value(); }
  /// Whether the mouse holds the part; else the drag is that of a typed number.
  [[nodiscard]] bool IsHeld() const { return this->Held; }

  /// Whether the widget would use a key without Ctrl and Alt: a character, or '\r' for Return, '\b' for Backspace, 27
  /// for Escape. A window asks this before its shortcuts. While a number is typed the widget uses all keys.
  [[nodiscard]] bool WantsKey(char key);

  /// Ends a drag as a release does. Call it when the widget loses the keyboard while a number is typed.
  void Keep();
  /// Ends a drag as Escape does. A chosen part stays chosen.
  void Cancel();

 protected:
  GizmoWidget();
  ~GizmoWidget() override { this->GizmoWidget::SetEnabled(0); }

  void OnChar() override;

 private:
  // One for each widget event: whether the VTK event has been used.
  bool Hover();
  void Leave();
  bool Press();
  bool Release();
  bool ChooseArrow() { return this->Choose(GizmoPart::ArrowX); }
  bool ChooseRing() { return this->Choose(GizmoPart::RingX); }
  bool Type();
  bool Correct();
  bool Complete();
  bool Reset();

  static void NoteButton(vtkObject* interactor, unsigned long event, void* self, void* callData);

  [[nodiscard]] DisplayPoint PixelCenter() const { return centerOfPixel(this->Cursor().x(), this->Cursor().y()); }
  [[nodiscard]] GizmoPart PartUnderCursor()
  {
    return static_cast<GizmoPart>(stateAtCursor(*this->WidgetRep, *this->Interactor));
  }
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
