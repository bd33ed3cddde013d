#include "holdfast/widgets/tools/gizmo_tool.h"

#include <numbers>

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/view/view_geometry.h>
#include <holdfast/widgets/viewport.h>

namespace holdfast {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

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
  const GizmoPartKind kind = kindOf(gizmo_.highlighted());
  if (kind == GizmoPartKind::Ring || kind == GizmoPartKind::ViewRing)
    return tr("Drag to turn, as many times round as you like; Ctrl snaps, Escape takes it back");
  return tr("Drag to move; Ctrl snaps, Escape takes it back");
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
  const GizmoPart part = partAt(pointer);
  if (part == GizmoPart::None) return false;
  drag_.emplace(part, gizmo_.frame(), viewGeometryOf(viewport_.renderer()), pointer.center(), gizmo_.ringPixels());
  const auto& selected = editor_.selectedConstraints();
  const QString what = selected.size() == 1 ? QString::fromStdString(editor_.list().constraints[selected.front()].name)
                                            : tr("%1 constraints").arg(selected.size());
  const GizmoPartKind kind = kindOf(part);
  const bool isTurn = kind == GizmoPartKind::Ring || kind == GizmoPartKind::ViewRing;
  editor_.beginGesture((isTurn ? tr("turn %1") : tr("move %1")).arg(what));
  return true;
}

void GizmoTool::drag(const Pointer& pointer)
{
  cursor_ = pointer.center();
  moveTo(drag_->to(pointer.center(), pointer.modifiers & Qt::ControlModifier ? Snap::On : Snap::None));
}

void GizmoTool::moveTo(const GizmoMotion& motion)
{
  const Vector3 pivot = drag_->frame().center;
  editor_.updateGesture(standing_->movedBy({motion.axis, motion.degrees, pivot, motion.translation}));
  gizmo_.setFrame(pivot + motion.translation, drag_->frame().axes);
  gizmo_.showDrag({drag_->part(), drag_->frame(), drag_->grabbed(), motion,
                   motionText(drag_->part(), motion, drag_->step(), editor_.list().units), cursor_});
  viewport_.scheduleRender();
}

void GizmoTool::release(const Pointer& pointer)
{
  drag(pointer);
  drag_.reset();
  gizmo_.endDrag();
  editor_.endGesture();
  stand();
}

bool GizmoTool::cancel()
{
  if (!drag_) return false;
  drag_.reset();
  gizmo_.endDrag();
  editor_.cancelGesture();
  stand();
  return true;
}

}  // namespace holdfast
