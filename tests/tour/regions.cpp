#include <cmath>
#include <numbers>
#include <vector>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {
namespace {

const Vector3 kEye(27, -84, 25);

void drawAroundEye(Stage& stage)
{
  stage.trigger("toolCurve");
  for (const Vector3& place : {Vector3(43, -76, 25), Vector3(27, -76, 41), Vector3(11, -76, 25)})
    test::click(stage.viewport(), stage.shownVertex(stage.nearestVertex(place)));
  test::moveMouse(stage.viewport(), stage.shownVertex(stage.nearestVertex({27, -76, 9})));
  stage.picture("curve_around_an_eye");
  test::click(stage.viewport(), stage.shownVertex(stage.nearestVertex({27, -76, 9})));
  test::pressKey(stage.viewport(), Qt::Key_Return);
  stage.picture("curve_closed");
  stage.trigger("makeRigid");
  stage.picture("eye_made_rigid");
}

void paint(Stage& stage)
{
  stage.trigger("toolBrush");
  const QPointF brow = stage.shown({-33, -76, 60});
  Viewport& viewport = stage.viewport();
  test::moveMouse(viewport, brow);
  test::pressMouse(viewport, brow);
  for (int step = 1; step <= 6; ++step) test::moveMouse(viewport, brow + QPointF(12 * step, -2 * step), Qt::LeftButton);
  stage.picture("brush");
  test::releaseMouse(viewport, brow + QPointF(72, -12));
  stage.trigger("deselect");
}

/// Shows the outline before the button is let go, and what it selects after.
void outline(Stage& stage, const char* tool, const std::vector<QPointF>& way, const std::string& name)
{
  stage.trigger(tool);
  test::pressMouse(stage.viewport(), way.front());
  for (const QPointF& place : way) test::moveMouse(stage.viewport(), place, Qt::LeftButton);
  stage.picture(name);
  test::releaseMouse(stage.viewport(), way.back());
  stage.picture(name + "_released");
  stage.trigger("deselect");
}

std::vector<QPointF> circle(const QPointF& middle, double radius)
{
  std::vector<QPointF> way;
  for (int step = 0; step <= 40; ++step) {
    const double angle = step * 2 * std::numbers::pi / 40;
    way.push_back(middle + radius * QPointF(std::cos(angle), 0.8 * std::sin(angle)));
  }
  return way;
}

}  // namespace

void regions(Stage& stage)
{
  stage.open("head.ply");
  stage.trigger("viewFront");
  drawAroundEye(stage);
  paint(stage);
  const QPointF eye = stage.shown(kEye);
  outline(stage, "toolRectangle", {eye - QPointF(60, 40), eye, eye + QPointF(40, 50)}, "rectangle");
  outline(stage, "toolLasso", circle(stage.shown({0, -104, 0}), 70), "lasso");

  stage.open("bracket.obj");
  stage.trigger("toolFlood");
  test::click(stage.viewport(), stage.shownVertex(stage.nearestVertex({20, 10, 12})));
  stage.settle();
  stage.picture("side");
  stage.trigger("makeFixed");
  stage.picture("side_fixed");
  stage.trigger("toolSelect");
}

}  // namespace holdfast::tour
