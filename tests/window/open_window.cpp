#include "open_window.h"

#include <QAction>
#include <cmath>

#include <vtkRenderer.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "gestures.h"
#include "support/source_tree.h"

namespace holdfast::test {

void OpenWindow::SetUp()
{
  window.resize(1270, 1000);
  ASSERT_TRUE(showAndWait(window));
}

void OpenWindow::open(const std::string& mesh, const std::string& constraints)
{
  NoProgress quiet;
  DocumentState state;
  if (!constraints.empty()) state.list = readConstraints(dataFolder() + "/" + constraints);
  editor().open(loadMesh(dataFolder() + "/" + mesh, quiet), std::move(state));
  ASSERT_TRUE(settle());
}

bool OpenWindow::settle(std::chrono::milliseconds limit)
{
  return waitUntil([&] { return editor().solveState() != SolveState::Solving && !viewport().isRenderPending(); },
                   limit);
}

void OpenWindow::trigger(const char* name)
{
  auto* action = window.findChild<QAction*>(name);
  ASSERT_NE(action, nullptr) << name;
  ASSERT_TRUE(action->isEnabled()) << name;
  action->trigger();
}

void OpenWindow::look(PlainView& view)
{
  view.width = viewport().width();
  view.height = viewport().height();
  test::look(*viewport().renderer().GetActiveCamera(), view);
  viewport().scheduleRender();
  ASSERT_TRUE(settle());
}

QPointF OpenWindow::inWidget(const Eigen::Vector2d& screen)
{
  return {std::floor(screen.x()) + 0.5, viewport().height() - std::floor(screen.y()) - 0.5};
}

QPointF OpenWindow::shownAt(const Vector3& place)
{
  return viewport().toPlace(toDisplay(viewport().renderer(), place).head<2>());
}

QPointF OpenWindow::onArrow(int axis)
{
  const GizmoFrame& frame = window.gizmo().gizmo().GetFrame();
  const QPointF center = shownAt(frame.center);
  const QPointF step = shownAt(Vector3(frame.center + frame.axes.col(axis))) - center;
  return center + 0.5 * kGizmoPixels / std::hypot(step.x(), step.y()) * step;
}

}  // namespace holdfast::test
