#include "open_window.h"

#include <cmath>

#include <vtkRenderer.h>

namespace holdfast::test {

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

}  // namespace holdfast::test
