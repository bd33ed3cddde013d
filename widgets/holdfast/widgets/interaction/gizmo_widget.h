#pragma once
/// Lets the user drag the gizmo, or type how far it moves.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/gizmo/gizmo_drag.h>
#include <holdfast/widgets/gizmo/gizmo_part_actors.h>
#include <holdfast/widgets/interaction/interaction_events.h>

namespace holdfast {

/// The default radius of the outer ring, in pixels of a display of ordinary resolution.
inline constexpr double kGizmoPixels = 115;

/// The motions that the gizmo offers. Points need only moves: they have nothing to rotate.
enum class GizmoMotions { Moves, MovesAndTurns };

/// Draws the gizmo and finds the part of it under the cursor. Arrows move along an axis, squares across one, the ball
/// across the view. Rings rotate about an axis, the outer ring about the view direction. A label says how far a drag
/// has gone.
///
/// The gizmo is drawn in a layer of its own over everything in the window. `SetRenderer` adds that layer; with null it
/// removes it. Each time the layer is drawn, the gizmo follows the camera of the renderer and keeps its size on the
/// display. A part that is seen from the end or the edge fades out and cannot be grabbed. The gizmo has no bounds, so
/// that cameras are not reset to it.
class GizmoRepresentation : public vtkWidgetRepresentation {
 public:
  static GizmoRepresentation* New();
  vtkTypeMacro(GizmoRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets where the gizmo is. By default it is at the origin, along the axes of the world. The columns of `axes` are
  /// orthonormal and right-handed. The call has no effect during a drag, which alone moves the gizmo then.
  void SetFrame(const Vector3& center, const Eigen::Matrix3d& axes);
  [[nodiscard]] const GizmoFrame& GetFrame() const { return this->Frame; }

  /// Sets the motions that the gizmo offers; `MovesAndTurns` by default. The call has no effect during a drag.
  void SetMotions(GizmoMotions motions);
  [[nodiscard]] GizmoMotions GetMotions() const { return this->Motions; }
  /// Tells whether these motions include the part. It returns false for `None`.
  [[nodiscard]] bool Offers(GizmoPart part) const
  {
    return part != GizmoPart::None && (this->Motions == GizmoMotions::MovesAndTurns || !isRotation(part));
  }

  /// Makes the gizmo take its axes from the view: right, up and towards the eye. They do not change during a drag. Off
  /// by default.
  vtkSetMacro(AlignToView, bool);
  vtkBooleanMacro(AlignToView, bool);

  /// Sets the radius of the outer ring in pixels of a display of ordinary resolution; `kGizmoPixels` by default.
  /// Widths, tolerances and letters follow it.
  vtkSetClampMacro(PixelSize, double, 1.0, 10000.0);
  vtkGetMacro(PixelSize, double);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// Sets the text that follows lengths in the label, such as "mm"; empty by default.
  vtkSetMacro(Units, std::string);
  [[nodiscard]] const std::string& GetUnits() const { return this->Units; }

  /// Sets the part that is drawn in yellow, also where it is seen from the end; `None` by default.
  vtkSetEnumMacro(Part, GizmoPart);
  [[nodiscard]] GizmoPart GetPart() const { return this->Part; }

  /// Returns a drag of the highlighted part, as the renderer sees it now. The highlighted part is not `None`.
  [[nodiscard]] GizmoDrag NewDrag(const DisplayPoint& cursor);
  /// Shows a drag: only the part of `trace` is drawn, where its motion has brought it, with its trace and `label`.
  void ShowDrag(const GizmoTrace& trace, const std::string& label, const DisplayPoint& cursor);
  /// Ends the drag. The gizmo stays where the last `ShowDrag` has brought it.
  void EndDrag();
  [[nodiscard]] bool IsDragging() const { return this->Drag.has_value(); }

  /// Sets whether the label is drawn; on by default. A window that draws its own label uses the two functions below.
  vtkSetMacro(LabelVisibility, bool);
  vtkBooleanMacro(LabelVisibility, bool);
  /// Returns the label, which says how far the drag has gone, in UTF-8. It is empty without a drag.
  [[nodiscard]] const std::string& GetLabel() const { return this->Label; }
  /// Returns the cursor of the drag, in pixels from the window's lower left corner.
  [[nodiscard]] const DisplayPoint& GetLabelPosition() const { return this->LabelPosition; }

  /// Returns the renderer of the layer, for a program that draws more there.
  [[nodiscard]] vtkRenderer* GetLayer() const { return this->Layer; }
  [[nodiscard]] vtkTextActor* GetLabelActor() const { return this->LabelActor; }

  /// Shows or hides the gizmo. Hiding it outside a drag also removes the highlight. It does not end a drag.
  void SetVisibility(vtkTypeBool isVisible) override;
  void SetRenderer(vtkRenderer* renderer) override;
  /// Places the gizmo as the camera sees it now. This takes about a millisecond.
  void BuildRepresentation() override;
  /// Returns the part under the pixel as an int. It is `GizmoPart::None` outside the renderer's viewport and while the
  /// gizmo is hidden.
  int ComputeInteractionState(int x, int y, int modify = 0) override;

 protected:
  GizmoRepresentation();
  ~GizmoRepresentation() override { this->GizmoRepresentation::SetRenderer(nullptr); }

 private:
  void AlignAxes(const DisplayTransform& view);
  void PlaceParts(const DisplayTransform& view, const GizmoPlacement& placement);
  void PlaceLetters(const DisplayTransform& view, const GizmoPlacement& placement);
  void PlaceLabel();
  [[nodiscard]] bool IsDrawn(GizmoPart part) const
  {
    return this->Visibility && this->Offers(part) && (!this->Drag || this->Drag->part == part);
  }
  [[nodiscard]] double Radius() const { return this->PixelSize * this->PixelRatio; }

  GizmoFrame Frame;
  GizmoMotions Motions = GizmoMotions::MovesAndTurns;
  bool AlignToView = false;
  double PixelSize = kGizmoPixels;
  double PixelRatio = 1;
  std::string Units;
  GizmoPart Part = GizmoPart::None;
  std::optional<GizmoTrace> Drag;
  bool LabelVisibility = true;
  std::string Label;
  DisplayPoint LabelPosition{0, 0};

  std::vector<std::unique_ptr<GizmoPartActors>> Parts;  // one for each but `None`, in their order
  GizmoTraceActors Trace;
  std::array<vtkNew<vtkTextActor>, 3> Letters;
  std::array<vtkNew<vtkCoordinate>, 3> LetterPlaces;
  vtkNew<vtkTextActor> LabelActor;
  vtkNew<vtkRenderer> Layer;
};

/// Moves and rotates an object by arrows, squares and rings, or by a typed number. The active part is the one under the
/// cursor, or the one that a key or `SetPart` has chosen. A chosen part stays active until Escape, another choice, or
/// the cursor on another part.
///
///     vtkNew<GizmoWidget> gizmo;
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
class GizmoWidget : public WidgetOf<GizmoRepresentation> {
 public:
  static GizmoWidget* New();
  vtkTypeMacro(GizmoWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] GizmoRepresentation* GetGizmoRepresentation() { return &this->Drawn(); }
  /// Enables or disables the widget. Disabling cancels a drag and removes the gizmo from the window.
  void SetEnabled(int isEnabled) override;

  [[nodiscard]] GizmoPart GetPart() { return this->Drawn().GetPart(); }
  /// Chooses a part; `None` chooses none. The call has no effect during a drag, while the widget is disabled, and for a
  /// part that is not offered.
  void SetPart(GizmoPart part);

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
  GizmoWidget();
  ~GizmoWidget() override { this->GizmoWidget::SetEnabled(0); }

  void OnChar() override;

 private:
  // There is one for each widget event. It returns whether it has used the VTK event.
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
