#pragma once
/// \file
/// Draws the gizmo over the scene of a renderer.

#include <string>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkWidgetRepresentation.h>

#include <holdfast/widgets/gizmo/gizmo.h>
#include <holdfast/widgets/gizmo/gizmo_drag.h>

class vtkTextActor;

namespace holdfast {

/// The gizmo, and a label that says how far a drag is. Both are drawn in a layer of their own over all that is in the
/// window: `SetRenderer` adds that layer, and with null removes it. Each time that the layer is drawn, the gizmo
/// follows the camera of the renderer, and has the same size on the display. Has no bounds: cameras are not reset to
/// it.
class GizmoRepresentation : public vtkWidgetRepresentation {
 public:
  static GizmoRepresentation* New();
  vtkTypeMacro(GizmoRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where the gizmo stands; at the origin along the axes of the world by default. The columns of `axes` are
  /// orthonormal and right-handed. Without effect during a drag, which alone moves the gizmo then.
  void SetFrame(const Vector3& center, const Eigen::Matrix3d& axes);
  [[nodiscard]] const GizmoFrame& GetFrame() const { return this->Drawing.frame(); }

  /// `MovesAndTurns` by default. Without effect during a drag.
  void SetMotions(GizmoMotions motions);
  [[nodiscard]] GizmoMotions GetMotions() const { return this->Motions; }
  /// Whether a part other than `None` belongs to these motions.
  [[nodiscard]] bool Offers(GizmoPart part) const;

  /// Whether the axes are those of the view: right, up and towards the eye. They stay as they are during a drag. Off by
  /// default.
  vtkSetMacro(AlignToView, bool);
  vtkGetMacro(AlignToView, bool);
  vtkBooleanMacro(AlignToView, bool);

  /// Radius of the outer ring in pixels of a display of ordinary resolution; 115 by default.
  vtkSetClampMacro(PixelSize, double, 1.0, 10000.0);
  vtkGetMacro(PixelSize, double);
  /// Pixels of the window for each of such a display; 1 by default.
  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  /// The text behind lengths; none by default.
  void SetUnits(const std::string& units);
  [[nodiscard]] const std::string& GetUnits() const { return this->Units; }

  /// The part that is drawn in yellow; `None` by default.
  void SetPart(GizmoPart part);
  [[nodiscard]] GizmoPart GetPart() const { return this->Drawing.highlighted(); }

  /// A drag of the part that is highlighted, which is not `None`, as the renderer sees it now.
  [[nodiscard]] GizmoDrag NewDrag(const DisplayPoint& cursor);
  /// From now on only the part of `trace` is drawn, where its motion has brought it, with its trace and `label`.
  /// `cursor`: the display point.
  void ShowDrag(const GizmoTrace& trace, const std::string& label, const DisplayPoint& cursor);
  /// The gizmo stays where the last `ShowDrag` has brought it.
  void EndDrag();
  [[nodiscard]] bool IsDragging() const { return this->Drawing.isDragging(); }

  /// Whether the label is drawn; on by default. A window that draws its own takes the two below.
  vtkSetMacro(LabelVisibility, bool);
  vtkGetMacro(LabelVisibility, bool);
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
  void BuildRepresentation() override;
  /// The part under the pixel as an int: `GizmoPart::None` beside all, outside of the renderer's viewport and while
  /// hidden.
  int ComputeInteractionState(int x, int y, int modify = 0) override;

 protected:
  GizmoRepresentation();
  ~GizmoRepresentation() override;

 private:
  GizmoRepresentation(const GizmoRepresentation&) = delete;
  void operator=(const GizmoRepresentation&) = delete;

  void ApplySettings();
  void PlaceLabel();

  Gizmo Drawing;
  vtkNew<vtkRenderer> Layer;
  vtkNew<vtkTextActor> LabelActor;
  GizmoMotions Motions = GizmoMotions::MovesAndTurns;
  bool AlignToView = false;
  double PixelSize = kGizmoPixels;
  double PixelRatio = 1;
  std::string Units;
  bool LabelVisibility = true;
  std::string Label;
  DisplayPoint LabelPosition{0, 0};
};

}  // namespace holdfast
