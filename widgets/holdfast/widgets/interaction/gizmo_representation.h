#pragma once
/// The handle that a user drags: three arrows, three squares, three rings, a ring about them and a ball in the middle.

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

#include <holdfast/widgets/gizmo/gizmo_part_actors.h>

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

  /// Whether the axes are those of the view: right, up and towards the eye. They stay as they are during a drag. Off by
  /// default.
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
  /// `cursor`: the display point.
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
  /// The part under the pixel as an int, see `hitGizmo`: `GizmoPart::None` outside of the renderer's viewport and while
  /// hidden.
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

}  // namespace holdfast
