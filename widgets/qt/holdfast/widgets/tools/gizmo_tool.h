#pragma once
/// \file
/// Moves the selected constraints by arrows, squares and rings.

#include <QFont>
#include <QRectF>
#include <QTimer>
#include <memory>
#include <optional>

#include <holdfast/document/constraint_drag.h>
#include <holdfast/view/gizmo.h>
#include <holdfast/view/gizmo_drag.h>
#include <holdfast/widgets/editor.h>
#include <holdfast/widgets/tool.h>
#include <holdfast/widgets/tools/typed_amount.h>

namespace holdfast {

class Viewport;

/// Along which axes the arrows point.
enum class GizmoAxes {
  Handle,  ///< those of the selected handle, turned with it; of a point: across the surface and along it
  World,
  View
};

/// Stands where the selected points and handles are to be, and is asked before any other tool. A drag is one edit, and
/// Escape takes it back. With Ctrl it snaps. A number typed while a part is held, or the cursor is over it, moves or
/// turns along that part by exactly so much: the mouse says no more then, and Enter, a click or letting go keeps it.
class GizmoTool : public Tool {
  Q_OBJECT

 public:
  GizmoTool(Editor& editor, Viewport& viewport, QObject* parent);
  ~GizmoTool() override;

  [[nodiscard]] QString hint() const override;
  bool press(const Pointer& pointer) override;
  bool hover(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void leave() override;
  [[nodiscard]] bool wants(const QKeyEvent& event) const override;
  bool key(const QKeyEvent& event) override;
  void loseFocus() override;
  bool cancel() override;
  /// How far the drag is, at the cursor.
  void paint(QPainter& painter) const override;

  /// What lies under that label, in the viewport's own coordinates and wholly inside it; empty without a drag.
  [[nodiscard]] QRectF labelPlate() const;

  void setAxes(GizmoAxes axes);
  [[nodiscard]] GizmoAxes axes() const noexcept { return axes_; }
  [[nodiscard]] const Gizmo& gizmo() const noexcept { return gizmo_; }
  /// Whether the cursor is over one of its parts, or drags it: `hint` is what counts then.
  [[nodiscard]] bool isTouched() const noexcept { return gizmo_.highlighted() != GizmoPart::None; }

  /// Follows the camera: before the viewport is drawn.
  void update();

 private:
  void stand();
  void grab(GizmoPart part);
  void follow(Snap snap);
  void moveByTyped();
  void moveTo(const GizmoMotion& motion, const std::string& label);
  void keep();
  [[nodiscard]] bool isTurn() const;
  [[nodiscard]] QFont labelFont() const;
  [[nodiscard]] Eigen::Matrix3d handleAxes() const;
  [[nodiscard]] Eigen::Matrix3d axesNow();
  void highlight(GizmoPart part);
  [[nodiscard]] GizmoPart partAt(const Pointer& pointer);

  Editor& editor_;
  Viewport& viewport_;
  Gizmo gizmo_;
  GizmoAxes axes_ = GizmoAxes::World;
  std::unique_ptr<ConstraintDrag> standing_;  // what the gizmo stands for; null where it is hidden
  std::optional<GizmoDrag> drag_;
  bool isHeld_ = false;  // by the mouse
  TypedAmount typed_;
  DisplayPoint cursor_{0, 0};
  QString label_;  // how far the drag is
};

}  // namespace holdfast
