#include "holdfast/window/tools/gizmo_tool.h"

#include <QFontMetricsF>
#include <QMarginsF>
#include <QPainter>
#include <utility>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/viewport/label_place.h>

namespace holdfast {
namespace {

// Up and to the right of the cursor, clear of what is dragged.
constexpr QPointF kLabelOffset(18, -16);
constexpr QMarginsF kLabelMargins(6, 3, 6, 3);

}  // namespace

GizmoTool::GizmoTool(Editor& editor, Viewport& viewport, QObject* parent)
    : ToolOf(editor, viewport, parent), gizmo_(*widget().GetGizmoRepresentation()), region_(viewport)
{
  // `paint` draws it in the window's font.
  gizmo_.LabelVisibilityOff();
  widget().AddObserver(vtkCommand::HighlightEvent, this, &GizmoTool::highlight);
  widget().AddObserver(vtkCommand::StartInteractionEvent, this, &GizmoTool::start);
  widget().AddObserver(vtkCommand::InteractionEvent, this, &GizmoTool::move);
  widget().AddObserver(vtkCommand::EndInteractionEvent, this, &GizmoTool::finish);
  widget().AddObserver(CancelInteractionEvent, this, &GizmoTool::finish);
  connect(&viewport, &Viewport::rendered, this, &GizmoTool::moveLabel);
  for (const auto& signal : {&Editor::opened, &Editor::stateChanged, &Editor::constraintSelectionChanged})
    connect(&editor, signal, this, &GizmoTool::placeGizmo);
  connect(&editor, &Editor::solveStateChanged, this, [this] {
    if (this->editor().solveState() != SolveState::Solving) region_.hide();
  });
}

QString GizmoTool::hint() const
{
  if (widget().IsDragging() && !widget().IsHeld())
    return tr("Enter keeps it, Backspace corrects it, Escape takes it back");
  return isRotation() ? tr("Drag to rotate, or type degrees; Ctrl snaps, Escape takes it back")
                      : tr("Drag to move, or type a length; Ctrl snaps, Escape takes it back");
}

void GizmoTool::highlight()
{
  if (isTouched()) viewport().leaveTool();
  Q_EMIT changed();
}

void GizmoTool::placeGizmo()
{
  if (widget().IsDragging()) return;
  placing_.reset();
  if (editor().isOpen() && !editor().selectedConstraints().empty()) try {
      placing_ = std::make_unique<ConstraintDrag>(*editor().model(), editor().list(), editor().selectedConstraints(),
                                                  editor().mesh().path.filename().string());
    } catch (const InputError&) {
      // A constraint does not fit the mesh: the editor reports it, and there is nothing to move.
      placing_.reset();
    }
  if (placing_ && placing_->isEmpty()) placing_.reset();
  if (!placing_) return widget().Off();
  gizmo_.SetMotions(motions());
  gizmo_.SetUnits(editor().list().units);
  placeFrame();
  widget().On();
  widget().Render();
}

GizmoMotions GizmoTool::motions() const
{
  if (placing_->canRotate()) return GizmoMotions::MovesAndTurns;
  const RowDirections directions = placing_->directions();
  if (directions.areAll()) return GizmoMotions::Moves;
  return directions.areAlongAxis() ? GizmoMotions::MovesAlongZ : GizmoMotions::MovesAcrossZ;
}

void GizmoTool::placeFrame()
{
  // A plane or a line moves along axes of its own.
  const GizmoAxes axes = placing_->directions().areAll() ? axes_ : GizmoAxes::Own;
  gizmo_.SetAlignToView(axes == GizmoAxes::View);
  gizmo_.SetFrame(placing_->center(),
                  axes == GizmoAxes::Own ? placing_->axes(editor().positions()) : Eigen::Matrix3d::Identity());
}

void GizmoTool::followSurface()
{
  // The axes of a point are those of the surface.
  if (placing_ && axes_ == GizmoAxes::Own && !widget().IsDragging()) placeFrame();
}

void GizmoTool::start()
{
  // What it shows under the cursor would stay behind.
  viewport().leaveTool();
  view_ = DisplayTransform(viewport().renderer());
  pivot_ = gizmo_.GetFrame().center;
  degreesSeen_ = 0;
  if (isLarge(*editor().model())) region_.begin(placing_->handleVertices());
  editor().beginGesture(
      (isRotation() ? tr("rotate %1") : tr("move %1")).arg(subjectOf(editor(), editor().selectedConstraints())));
}

RigidIncrement GizmoTool::incrementOf(const GizmoMotion& motion)
{
  const auto& fixed = placing_->fixedCenter();
  if (rotationOfMoves_ == RotationOfMoves::AsConstraint || isRotation() || !fixed)
    return {motion.axis, motion.degrees, pivot_, motion.translation};
  degreesSeen_ = degreesSeen(view_, *fixed, pivot_, pivot_ + motion.translation, degreesSeen_);
  return {-view_.direction(), degreesSeen_, pivot_, motion.translation};
}

void GizmoTool::move(vtkObject* /*caller*/, unsigned long /*event*/, void* motion)
{
  ConstraintList moved = placing_->movedBy(incrementOf(*static_cast<const GizmoMotion*>(motion)));
  showRegion(moved);
  editor().updateGesture(std::move(moved));
}

void GizmoTool::showRegion(const ConstraintList& moved)
{
  if (!isLarge(*editor().model()) || !placing_->hasHandles()) return;
  try {
    region_.moveTo(placing_->handlePlaces(moved));
  } catch (const InputError&) {
    // The editor reports what the handle cannot do.
    region_.hide();
  }
}

void GizmoTool::finish(vtkObject* /*caller*/, unsigned long event, void* /*data*/)
{
  if (event == CancelInteractionEvent)
    editor().cancelGesture();
  else
    editor().endGesture();
  placeGizmo();
  Q_EMIT changed();
}

std::vector<Vector3> GizmoTool::extent() const
{
  if (!placing_) return {};
  const DisplayTransform view(viewport().renderer());
  const Vector3& center = gizmo_.GetFrame().center;
  const double radius = placementOf(view, gizmo_.GetFrame(), gizmo_.GetPixelSize() * gizmo_.GetPixelRatio()).scale;
  return {center - radius * view.right(), center + radius * view.right(), center - radius * view.up(),
          center + radius * view.up()};
}

QRectF GizmoTool::labelPlate() const
{
  if (!widget().IsDragging()) return {};
  QRectF plate = QFontMetricsF(labelFont()).boundingRect(QString::fromStdString(gizmo_.GetLabel())) + kLabelMargins;
  plate.moveBottomLeft(viewport().toPlace(gizmo_.GetLabelPosition()) + kLabelOffset);
  return movedInto(plate, viewport().rect());
}

void GizmoTool::moveLabel()
{
  const QRect plate = labelPlate().toAlignedRect();
  for (const QRect& area : {std::exchange(painted_, plate), plate})
    if (!area.isEmpty()) Q_EMIT paintChanged(area);
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
  painter.drawText(plate, Qt::AlignCenter, QString::fromStdString(gizmo_.GetLabel()));
}

bool GizmoTool::cancel()
{
  const bool wasDragging = widget().IsDragging();
  widget().Cancel();
  return wasDragging;
}

}  // namespace holdfast
