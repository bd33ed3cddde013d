#pragma once
/// Draws the gizmo, and finds the part of it under the cursor.

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

/// The motions that the gizmo offers. Points need only moves: they have nothing to rotate. A plane needs only a move
/// along its normal, and a line those across itself.
enum class GizmoMotions {
  Moves,
  MovesAndTurns,
  MovesAlongZ,  ///< the arrow of the third axis
  MovesAcrossZ  ///< the arrows of the others, and the square across the third axis
};

}  // namespace holdfast

/// Draws the gizmo and finds the part of it under the cursor. Arrows move along an axis, squares across one, the ball
/// across the view. Rings rotate about an axis, the outer ring about the view direction. A label says how far a drag
/// has gone.
///
/// The gizmo is drawn in a layer of its own over everything in the window. `SetRenderer` adds that layer; with null it
/// removes it. Each time the layer is drawn, the gizmo follows the camera of the renderer and keeps its size on the
/// display. A part that is seen from the end or the edge fades out and cannot be grabbed. The gizmo has no bounds, so
/// that cameras are not reset to it.
class vtkHoldfastGizmoRepresentation : public vtkWidgetRepresentation {
 public:
  static vtkHoldfastGizmoRepresentation* New();
  vtkTypeMacro(vtkHoldfastGizmoRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets where the gizmo is. By default it is at the origin, along the axes of the world. The columns of `axes` are
  /// orthonormal and right-handed. The call has no effect during a drag, which alone moves the gizmo then.
  void SetFrame(const holdfast::Vector3& center, const Eigen::Matrix3d& axes);
  [[nodiscard]] const holdfast::GizmoFrame& GetFrame() const { return this->Frame; }

  /// Sets the motions that the gizmo offers; `MovesAndTurns` by default. The call has no effect during a drag.
  void SetMotions(holdfast::GizmoMotions motions);
  [[nodiscard]] holdfast::GizmoMotions GetMotions() const { return this->Motions; }
  /// Tells whether these motions include the part. It returns false for `None`.
  [[nodiscard]] bool Offers(holdfast::GizmoPart part) const;

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
  vtkSetEnumMacro(Part, holdfast::GizmoPart);
  [[nodiscard]] holdfast::GizmoPart GetPart() const { return this->Part; }

  /// Returns a drag of the highlighted part, as the renderer sees it now. The highlighted part is not `None`.
  [[nodiscard]] holdfast::GizmoDrag NewDrag(const holdfast::DisplayPoint& cursor);
  /// Shows a drag: only the part of `trace` is drawn, where its motion has brought it, with its trace and `label`.
  void ShowDrag(const holdfast::GizmoTrace& trace, const std::string& label, const holdfast::DisplayPoint& cursor);
  /// Ends the drag. The gizmo stays where the last `ShowDrag` has brought it.
  void EndDrag();
  [[nodiscard]] bool IsDragging() const { return this->Drag.has_value(); }

  /// Sets whether the label is drawn; on by default. A window that draws its own label uses the two functions below.
  vtkSetMacro(LabelVisibility, bool);
  vtkBooleanMacro(LabelVisibility, bool);
  /// Returns the label, which says how far the drag has gone, in UTF-8. It is empty without a drag.
  [[nodiscard]] const std::string& GetLabel() const { return this->Label; }
  /// Returns the cursor of the drag, in pixels from the window's lower left corner.
  [[nodiscard]] const holdfast::DisplayPoint& GetLabelPosition() const { return this->LabelPosition; }

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
  vtkHoldfastGizmoRepresentation();
  ~vtkHoldfastGizmoRepresentation() override { this->vtkHoldfastGizmoRepresentation::SetRenderer(nullptr); }

 private:
  void AlignAxes(const holdfast::DisplayTransform& view);
  void PlaceParts(const holdfast::DisplayTransform& view, const holdfast::GizmoPlacement& placement);
  void PlaceLetters(const holdfast::DisplayTransform& view, const holdfast::GizmoPlacement& placement);
  void PlaceLabel();
  [[nodiscard]] bool IsDrawn(holdfast::GizmoPart part) const
  {
    return this->Visibility && this->Offers(part) && (!this->Drag || this->Drag->part == part);
  }
  [[nodiscard]] double Radius() const { return this->PixelSize * this->PixelRatio; }

  holdfast::GizmoFrame Frame;
  holdfast::GizmoMotions Motions = holdfast::GizmoMotions::MovesAndTurns;
  bool AlignToView = false;
  double PixelSize = holdfast::kGizmoPixels;
  double PixelRatio = 1;
  std::string Units;
  holdfast::GizmoPart Part = holdfast::GizmoPart::None;
  std::optional<holdfast::GizmoTrace> Drag;
  bool LabelVisibility = true;
  std::string Label;
  holdfast::DisplayPoint LabelPosition{0, 0};

  std::vector<std::unique_ptr<holdfast::GizmoPartActors>> Parts;  // one for each but `None`, in their order
  holdfast::GizmoTraceActors Trace;
  std::array<vtkNew<vtkTextActor>, 3> Letters;
  std::array<vtkNew<vtkCoordinate>, 3> LetterPlaces;
  vtkNew<vtkTextActor> LabelActor;
  vtkNew<vtkRenderer> Layer;
};
