#include <cmath>
#include <numbers>
#include <vector>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {
namespace {

const Vector3 kEye(27, -84, 25);

void drawAroundEye(TourWindow& tour)
{
  tour.trigger("toolCurve");
  for (const Vector3& place : {Vector3(43, -76, 25), Vector3(27, -76, 41), Vector3(11, -76, 25)})
    test::click(tour.viewport(), tour.shownVertex(tour.nearestVertex(place)));
  test::moveMouse(tour.viewport(), tour.shownVertex(tour.nearestVertex({27, -76, 9})));
  tour.picture("curve_around_an_eye");
  test::click(tour.viewport(), tour.shownVertex(tour.nearestVertex({27, -76, 9})));
  test::pressKey(tour.viewport(), Qt::Key_Return);
  tour.picture("curve_closed");
  tour.trigger("makeRigid");
  tour.picture("eye_made_rigid");
}

void paint(TourWindow& tour)
{
  tour.trigger("toolBrush");
  const QPointF brow = tour.shownAt({-33, -76, 60});
  Viewport& viewport = tour.viewport();
  test::moveMouse(viewport, brow);
  test::pressMouse(viewport, brow);
  for (int step = 1; step <= 6; ++step) test::moveMouse(viewport, brow + QPointF(12 * step, -2 * step), Qt::LeftButton);
  tour.picture("brush");
  test::releaseMouse(viewport, brow + QPointF(72, -12));
  tour.trigger("deselect");
}

/// Shows the outline before the button is let go, and what it selects after.
void outline(TourWindow& tour, const char* tool, const std::vector<QPointF>& way, const std::string& name)
{
  tour.trigger(tool);
  test::pressMouse(tour.viewport(), way.front());
  for (const QPointF& place : way) test::moveMouse(tour.viewport(), place, Qt::LeftButton);
  tour.picture(name);
  test::releaseMouse(tour.viewport(), way.back());
  tour.picture(name + "_released");
  tour.trigger("deselect");
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

void regions(TourWindow& tour)
{
  tour.open("head.ply");
  tour.trigger("viewFront");
  drawAroundEye(tour);
  paint(tour);
  const QPointF eye = tour.shownAt(kEye);
  outline(tour, "toolRectangle", {eye - QPointF(60, 40), eye, eye + QPointF(40, 50)}, "rectangle");
  outline(tour, "toolLasso", circle(tour.shownAt({0, -104, 0}), 70), "lasso");

  tour.open("bracket.obj");
  tour.trigger("toolFlood");
  test::click(tour.viewport(), tour.shownVertex(tour.nearestVertex({20, 10, 12})));
  tour.settle();
  tour.picture("side");
  tour.trigger("makeFixed");
  tour.picture("side_fixed");
  tour.trigger("toolSelect");
}

}  // namespace holdfast::tour
