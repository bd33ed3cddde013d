#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {

void rotations(TourWindow& tour)
{
  tour.open("bar.obj", "bar.twist_360.constraints.json");
  tour.raise("colorsDock");
  tour.choose("colorField", static_cast<int>(ColorBy::Angle));
  tour.raise("sphereDock");
  tour.picture("bar_twisted_once_around");
  tour.trigger("toolPoint");
  test::moveMouse(tour.viewport(), tour.shownVertex(tour.nearestVertex({5, 0, 50})));
  tour.picture("rotation_under_the_cursor");
  tour.trigger("toolSelect");
  tour.raise("histogramDock");
  tour.picture("distributions");
  tour.raise("colorsDock");
  tour.choose("colorField", static_cast<int>(ColorBy::Displacement));
  tour.raise("constraintsDock");
}

}  // namespace holdfast::tour
