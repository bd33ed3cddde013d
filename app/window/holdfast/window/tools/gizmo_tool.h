#pragma once
/// Moves the selected constraints by arrows, squares and rings.

#include <QFont>
#include <QRectF>
#include <memory>

#include <holdfast/document/constraint_drag.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h>
#include <holdfast/window/tools/moved_region.h>
#include <holdfast/window/tools/tools.h>

namespace holdfast {

/// The axes along which the arrows point.
enum class GizmoAxes {
  Own,  ///< `ConstraintDrag::axes`: of a handle, turned with it; of a point, across the surface and along it
  World,
  View
};

/// Says how a handle turns while it is moved about what is fixed. Section 3.3 of the paper describes these movements.
enum class RotationOfMoves {
  AsConstraint,  ///< as the handle says, for example by the shortest rotation (`RotationAboutFixed`)
  AsSeen         ///< by the angle on the screen, about the viewing axis
};

/// The tool shows the gizmo where the selected points and handles go, whichever tool is chosen. A drag is one edit.
class GizmoTool : public ToolOf<vtkHoldfastGizmoWidget> {
 public:
  GizmoTool(Editor& editor, Viewport& viewport, QObject* parent);

  [[nodiscard]] QString hint() const override;
  void begin() override { placeGizmo(); }
  [[nodiscard]] bool wants(const QKeyEvent& event) const override
  {
    // Escape is the window's, and comes as `cancel`.
    return characterOf(event) != 27 && widget().WantsKey(characterOf(event));
  }
  void loseFocus() override
  {
    if (widget().IsDragging() && !widget().IsHeld()) widget().Keep();
  }
  bool cancel() override;
  /// Returns the extent of the outer ring, also where the gizmo has none: letters reach nearly as far.
  [[nodiscard]] std::vector<Vector3> extent() const override;
  void paint(QPainter& painter) const override;

  /// Returns the box of the drag's label, in the viewport's coordinates and inside the viewport. It is empty without a
  /// drag.
  [[nodiscard]] QRectF labelPlate() const;

  void setAxes(GizmoAxes axes)
  {
    axes_ = axes;
    placeGizmo();
  }
  [[nodiscard]] GizmoAxes axes() const noexcept { return axes_; }
  void setRotationOfMoves(RotationOfMoves turn) { rotationOfMoves_ = turn; }

  [[nodiscard]] const vtkHoldfastGizmoRepresentation& gizmo() const noexcept { return gizmo_; }
  [[nodiscard]] MovedRegion& movedRegion() noexcept { return region_; }
  /// Tells whether the cursor is over a part of the gizmo, or drags it. `hint` applies then.
  [[nodiscard]] bool isTouched() const { return widget().GetPart() != GizmoPart::None; }

 protected:
  void followSurface() override;
  void followDisplay() override { gizmo_.SetPixelRatio(viewport().pixelRatio()); }

 private:
  void placeGizmo();
  [[nodiscard]] GizmoMotions motions() const;
  void placeFrame();
  void moveLabel();
  void highlight();
  void start();
  void move(vtkObject* caller, unsigned long event, void* motion);
  void showRegion(const ConstraintList& moved);
  void finish(vtkObject* caller, unsigned long event, void* data);
  [[nodiscard]] bool isRotation() const { return holdfast::isRotation(widget().GetPart()); }
  [[nodiscard]] RigidIncrement incrementOf(const GizmoMotion& motion);
  [[nodiscard]] QFont labelFont() const
  {
    QFont font = viewport().font();
    font.setBold(true);
    return font;
  }

  vtkHoldfastGizmoRepresentation& gizmo_;
  MovedRegion region_;
  GizmoAxes axes_ = GizmoAxes::World;
  RotationOfMoves rotationOfMoves_ = RotationOfMoves::AsConstraint;
  std::unique_ptr<ConstraintDrag> placing_;  // what the gizmo moves; null while it is hidden
  DisplayTransform view_;                    // when the drag began
  Vector3 pivot_ = Vector3::Zero();
  double degreesSeen_ = 0;  // so far
  QRect painted_;           // by the label
};

}  // namespace holdfast
