#pragma once
/// Lets the user drag the gizmo, or type how far.

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

/// The radius of the outer ring by default, pixels of a display of ordinary resolution.
inline constexpr double kGizmoPixels = 115;

/// The motions that the gizmo offers: points have nothing to rotate.
enum class GizmoMotions { Moves, MovesAndTurns };

/// Arrows move along an axis, squares across one, the ball across the view; rings rotate about an axis, the outer one
/// about the view direction. A label says how far a drag is. All is drawn in a layer of its own over everything in the
/// window: `SetRenderer` adds that layer, and with null removes it. Each time that the layer is drawn, the gizmo
/// follows the camera of the renderer, and has the same size on the display. What is seen from the end or the edge
/// fades out and cannot be grabbed. Has no bounds: cameras are not reset to it.
class GizmoRepresentation : public vtkWidgetRepresentation {
 public:
  static GizmoRepresentation* New();
  vtkTypeMacro(GizmoRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where the gizmo is; at the origin along the axes of the world by default. The columns of `axes` are orthonormal
  /// and right-handed. Without effect during a drag, which alone moves the gizmo then.
  void SetFrame(const Vector3& center, const Eigen::Matrix3d& axes);
  [[nodiscard]] const GizmoFrame& GetFrame() const { return this->Frame; }

  /// `MovesAndTurns` by default. Without effect during a drag.
  void SetMotions(GizmoMotions motions);
  [[nodiscard]] GizmoMotions GetMotions() const { return this->Motions; }
  /// Whether a part other than `None` belongs to these motions.
  [[nodiscard]] bool Offers(GizmoPart part) const
  {
    return part != GizmoPart::None && (this->Motions == GizmoMotions::MovesAndTurns || !isRotation(part));
  }

  /// Whether the axes are those of the view (not during a drag): right, up and towards the eye. Off by default.
  vtkSetMacro(AlignToView, bool);
  vtkBooleanMacro(AlignToView, bool);

  /// Radius of the outer ring, `kGizmoPixels` by default; widths, tolerances and texts follow.
  vtkSetClampMacro(PixelSize, double, 1.0, 10000.0);
  vtkGetMacro(PixelSize, double);
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// The text behind lengths; none by default.
  vtkSetMacro(Units, std::string);
  [[nodiscard]] const std::string& GetUnits() const { return this->Units; }

  /// The part that is drawn in yellow, also where it is seen from the end; `None` by default.
  vtkSetEnumMacro(Part, GizmoPart);
  [[nodiscard]] GizmoPart GetPart() const { return this->Part; }

  /// A drag of the part that is highlighted, which is not `None`, as the renderer sees it now.
  [[nodiscard]] GizmoDrag NewDrag(const DisplayPoint& cursor);
  /// From now on only the part of `trace` is drawn, where its motion has brought it, with its trace and `label`.
  void ShowDrag(const GizmoTrace& trace, const std::string& label, const DisplayPoint& cursor);
  /// The gizmo stays where the last `ShowDrag` has brought it.
  void EndDrag();
  [[nodiscard]] bool IsDragging() const { return this->Drag.has_value(); }

  /// Whether the label is drawn; on by default. A window that draws its own takes the two below.
  vtkSetMacro(LabelVisibility, bool);
  vtkBooleanMacro(LabelVisibility, bool);
  /// How far the drag is, in UTF-8; empty without a drag.
  [[nodiscard]] const std::string& GetLabel() const { return this->Label; }
  /// The cursor of the drag, pixels from the window's lower left corner.
  [[nodiscard]] const DisplayPoint& GetLabelPosition() const { return this->LabelPosition; }

  /// The layer's renderer, for what else is to be drawn there.
  [[nodiscard]] vtkRenderer* GetLayer() const { return this->Layer; }
  [[nodiscard]] vtkTextActor* GetLabelActor() const { return this->LabelActor; }

  /// Hiding highlights no part any more. It does not end a drag.
  void SetVisibility(vtkTypeBool isVisible) override;
  void SetRenderer(vtkRenderer* renderer) override;
  /// About a millisecond.
  void BuildRepresentation() override;
  /// The part under the pixel as an int; `GizmoPart::None` outside of the renderer's viewport and while hidden.
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
