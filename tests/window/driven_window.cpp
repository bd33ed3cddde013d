#include "window/driven_window.h"

#include <QAction>
#include <cmath>

#include <vtkRenderer.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "support/source_tree.h"
#include "window/gestures.h"

namespace holdfast::test {

void DrivenWindow::show(int width, int height)
{
  window.resize(width, height);
  if (!showAndWait(window)) throw std::runtime_error("the window does not come up");
}

void DrivenWindow::open(const std::string& mesh, const std::string& constraints)
{
  NoProgress quiet;
  DocumentState state;
  if (!constraints.empty()) state.list = readConstraints(dataFolder() + "/" + constraints);
  editor().open(loadMesh(dataFolder() + "/" + mesh, quiet), std::move(state));
  if (!settle()) throw std::runtime_error(mesh + " is not solved and drawn");
}

bool DrivenWindow::settle(std::chrono::milliseconds limit)
{
  return waitUntil([&] { return editor().solveState() != SolveState::Solving && !viewport().isRenderPending(); },
                   limit);
}

void DrivenWindow::trigger(const char* name)
{
  auto& action = find<QAction>(name);
  if (!action.isEnabled()) throw std::runtime_error(std::string("not enabled: ") + name);
  action.trigger();
}

QPointF DrivenWindow::shownAt(const Vector3& place)
{
  return viewport().toPlace(toDisplay(viewport().renderer(), place).head<2>());
}

QPointF DrivenWindow::onArrow(int axis)
{
  const GizmoFrame& frame = window.gizmo().gizmo().GetFrame();
  const QPointF center = shownAt(frame.center);
  const QPointF step = shownAt(Vector3(frame.center + frame.axes.col(axis))) - center;
  return center + 0.5 * kGizmoPixels / std::hypot(step.x(), step.y()) * step;
}

Index DrivenWindow::nearestVertex(const Vector3& place)
{
  Index nearest = 0;
  (editor().positions().rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

}  // namespace holdfast::test
