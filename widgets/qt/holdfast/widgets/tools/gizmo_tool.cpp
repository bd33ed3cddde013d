#include "holdfast/widgets/tools/gizmo_tool.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMarginsF>
#include <QPainter>
#include <algorithm>

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <holdfast/base/degree.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/view/view_geometry.h>
#include <holdfast/widgets/constraint_words.h>
#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

// Up and to the right of the cursor, clear of what is dragged.
constexpr QPointF kLabelOffset(18, -16);
constexpr QMarginsF kLabelMargins(6, 3, 6, 3);

/// Where it is as a whole within `room`, as near as can be.
QRectF movedInto(QRectF box, const QRectF& room)
{
  box.moveLeft(std::max(room.left(), std::min(box.left(), room.right() - box.width())));
  box.moveTop(std::max(room.top(), std::min(box.top(), room.bottom() - box.height())));
  return box;
}

}  // namespace

GizmoTool::GizmoTool(Editor& editor, Viewport& viewport, QObject* parent)
    : Tool(parent), editor_(editor), viewport_(viewport)
{
  gizmo_.addTo(viewport_.frontRenderer());
  gizmo_.hide();
  for (const auto& signal : {&Editor::opened, &Editor::stateChanged, &Editor::constraintSelectionChanged})
    connect(&editor_, signal, this, &GizmoTool::stand);
  connect(&viewport_, &Viewport::aboutToRender, this, &GizmoTool::update);
}

GizmoTool::~GizmoTool() = default;

QString GizmoTool::hint() const
{
  if (!typed_.isEmpty()) return tr("Enter keeps it, Backspace corrects it, Escape takes it back");
  return isTurn() ? tr("Drag to turn, or type degrees; Ctrl snaps, Escape takes it back")
                  : tr("Drag to move, or type a length; Ctrl snaps, Escape takes it back");
}

bool GizmoTool::isTurn() const
{
  const GizmoPartKind kind = kindOf(gizmo_.highlighted());
  return kind == GizmoPartKind::Ring || kind == GizmoPartKind::ViewRing;
}

void GizmoTool::highlight(GizmoPart part)
{
  if (part == gizmo_.highlighted()) return;
  gizmo_.highlight(part);
  viewport_.scheduleRender();
  Q_EMIT changed();
}

void GizmoTool::stand()
{
  if (drag_) return;
  standing_.reset();
  if (editor_.isOpen() && !editor_.selectedConstraints().empty()) try {
      standing_ = std::make_unique<ConstraintDrag>(*editor_.model(), editor_.list(), editor_.selectedConstraints(),
                                                   editor_.mesh().path.filename().string());
    } catch (const InputError&) {
      // A constraint that does not fit the mesh: the editor's trouble says so, and there is nothing to move.
      standing_.reset();
    }
  if (standing_ && standing_->isEmpty()) standing_.reset();
  if (standing_) {
    gizmo_.setFrame(standing_->center(), axesNow());
    gizmo_.show(standing_->hasHandles() ? GizmoMotions::MovesAndTurns : GizmoMotions::Moves);
  } else {
    gizmo_.hide();
    highlight(GizmoPart::None);
  }
  viewport_.scheduleRender();
}

Eigen::Matrix3d GizmoTool::handleAxes() const
{
  const auto& selected = editor_.selectedConstraints();
  const auto* handle = std::get_if<Handle>(&editor_.list().constraints[selected.front()].what);
  if (!handle) return Eigen::Matrix3d::Identity();
  if (const auto* turn = std::get_if<Turn>(&handle->motion))
    return Eigen::AngleAxisd(turn->degrees * kDegree, turn->axis.normalized()).toRotationMatrix();
  if (const auto* motion = std::get_if<FrameMotion>(&handle->motion)) return axesOf(motion->to);
  return Eigen::Matrix3d::Identity();
}

Eigen::Matrix3d GizmoTool::axesNow()
{
  switch (axes_) {
    case GizmoAxes::Handle:
      return handleAxes();
    case GizmoAxes::View: {
      const ViewGeometry view = viewGeometryOf(viewport_.renderer());
      Eigen::Matrix3d axes;
      axes << view.right, view.up, -view.direction;
      return axes;
    }
    case GizmoAxes::World:
      break;
  }
  return Eigen::Matrix3d::Identity();
}

void GizmoTool::setAxes(GizmoAxes axes)
{
  axes_ = axes;
  stand();
}

void GizmoTool::update()
{
  if (standing_ && axes_ == GizmoAxes::View && !drag_) gizmo_.setFrame(gizmo_.frame().center, axesNow());
  gizmo_.setPixelSize(kGizmoPixels * viewport_.pixelRatio());
  gizmo_.update(viewport_.renderer());
}

GizmoPart GizmoTool::partAt(const Pointer& pointer)
{
  if (!standing_) return GizmoPart::None;
  return gizmo_.hitTest(viewport_.renderer(), pointer.center().x(), pointer.center().y());
}

bool GizmoTool::hover(const Pointer& pointer)
{
  if (drag_) return true;
  cursor_ = pointer.center();
  const GizmoPart part = partAt(pointer);
  highlight(part);
  return part != GizmoPart::None;
}

void GizmoTool::leave()
{
  if (!drag_) highlight(GizmoPart::None);
}

bool GizmoTool::press(const Pointer& pointer)
{
  if (drag_) {
    keep();
    return true;
  }
  const GizmoPart part = partAt(pointer);
  if (part == GizmoPart::None) return false;
  cursor_ = pointer.center();
  highlight(part);
  grab(part);
  isHeld_ = true;
  return true;
}

void GizmoTool::grab(GizmoPart part)
{
  drag_.emplace(part, gizmo_.frame(), viewGeometryOf(viewport_.renderer()), cursor_, gizmo_.ringPixels());
  const auto& selected = editor_.selectedConstraints();
  const QString what = selected.size() == 1 ? nameText(editor_.list().constraints[selected.front()].name)
                                            : tr("%1 constraints").arg(selected.size());
  editor_.beginGesture((isTurn() ? tr("turn %1") : tr("move %1")).arg(what));
}

void GizmoTool::drag(const Pointer& pointer)
{
  if (!drag_) return;
  cursor_ = pointer.center();
  if (typed_.isEmpty()) follow(pointer.modifiers & Qt::ControlModifier ? Snap::On : Snap::None);
}

void GizmoTool::follow(Snap snap)
{
  const GizmoMotion motion = drag_->to(cursor_, snap);
  moveTo(motion, motionText(drag_->part(), motion, drag_->step(), editor_.list().units));
}

void GizmoTool::moveByTyped()
{
  moveTo(drag_->typed(typed_.value()),
         typed_.text().toStdString() + "_" + motionUnit(drag_->part(), editor_.list().units));
}

void GizmoTool::moveTo(const GizmoMotion& motion, const std::string& label)
{
  const Vector3 pivot = drag_->frame().center;
  editor_.updateGesture(standing_->movedBy({motion.axis, motion.degrees, pivot, motion.translation}));
  gizmo_.setFrame(pivot + motion.translation, drag_->frame().axes);
  gizmo_.showDrag({drag_->part(), drag_->frame(), drag_->grabbed(), motion});
  label_ = QString::fromStdString(label);
  viewport_.scheduleRender();
}

QFont GizmoTool::labelFont() const
{
  QFont font = viewport_.font();
  font.setBold(true);
  return font;
}

QRectF GizmoTool::labelPlate() const
{
  if (!drag_) return {};
  QRectF plate = QFontMetricsF(labelFont()).boundingRect(label_) + kLabelMargins;
  plate.moveBottomLeft(viewport_.toPlace(cursor_) + kLabelOffset);
  return movedInto(plate, viewport_.rect());
}

void GizmoTool::paint(QPainter& painter) const
{
  const QRectF plate = labelPlate();
  if (plate.isEmpty()) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(255, 255, 255, 210));
  painter.drawRoundedRect(plate, 4, 4);
  painter.setFont(labelFont());
  painter.setPen(QColor(33, 38, 48));
  painter.drawText(plate, Qt::AlignCenter, label_);
}

void GizmoTool::release(const Pointer& pointer)
{
  if (!drag_) return;
  drag(pointer);
  keep();
}

void GizmoTool::keep()
{
  drag_.reset();
  isHeld_ = false;
  typed_.clear();
  gizmo_.endDrag();
  editor_.endGesture();
  stand();
  Q_EMIT changed();
}

bool GizmoTool::wants(const QKeyEvent& event) const
{
  // Nothing else is edited before the number is.
  if (!typed_.isEmpty()) return event.key() != Qt::Key_Escape;
  return isTouched() && TypedAmount::isBegunBy(event);
}

bool GizmoTool::key(const QKeyEvent& event)
{
  if (!wants(event)) return false;
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    keep();
    return true;
  }
  if (event.key() == Qt::Key_Backspace)
    typed_.chop();
  else if (!typed_.add(event))
    return true;
  if (!drag_) grab(gizmo_.highlighted());
  if (!typed_.isEmpty())
    moveByTyped();
  else if (isHeld_)
    follow(Snap::None);
  else
    cancel();
  Q_EMIT changed();
  return true;
}

void GizmoTool::loseFocus()
{
  if (drag_ && !isHeld_) keep();
}

bool GizmoTool::cancel()
{
  if (!drag_) return false;
  drag_.reset();
  isHeld_ = false;
  typed_.clear();
  gizmo_.endDrag();
  editor_.cancelGesture();
  stand();
  Q_EMIT changed();
  return true;
}

}  // namespace holdfast
