#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {

void rotations(Stage& stage)
{
  stage.open("bar.obj", "bar.twist_360.constraints.json");
  stage.raise("colorsDock");
  stage.choose("colorField", static_cast<int>(ColorBy::Angle));
  stage.raise("sphereDock");
  stage.picture("bar_twisted_once_around");
  stage.trigger("toolPoint");
  test::moveMouse(stage.viewport(), stage.shownVertex(stage.nearestVertex({5, 0, 50})));
  stage.picture("rotation_under_the_cursor");
  stage.trigger("toolSelect");
  stage.raise("histogramDock");
  stage.picture("distributions");
  stage.raise("colorsDock");
  stage.choose("colorField", static_cast<int>(ColorBy::Displacement));
  stage.raise("constraintsDock");
}

}  // namespace holdfast::tour
