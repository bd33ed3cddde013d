#include <QDialog>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {
namespace {

void dark(Stage& stage)
{
  stage.window().setAppearance(Appearance::Dark);
  stage.open("bracket.obj", "bracket.constraints.json");
  stage.select("flange east");
  stage.picture("dark");
  stage.open("bracket.obj", "bracket.conflict.constraints.json");
  stage.raise("conflictsDock");
  stage.raise("colorsDock");
  stage.picture("dark_conflicts_and_colours");
  stage.open("bar.obj", "bar.twist_360.constraints.json");
  stage.raise("sphereDock");
  stage.raise("reportDock");
  stage.picture("dark_rotations_and_report");
  stage.raise("histogramDock");
  stage.picture("dark_distributions");
  stage.raise("constraintsDock");
  stage.raise("inspectorDock");
  stage.window().setAppearance(Appearance::Light);
}

/// A cut through the mesh, and a distance on it.
void inside(Stage& stage)
{
  stage.open("bracket.obj", "bracket.constraints.json");
  stage.trigger("sectionPlane");
  test::moveMouse(stage.viewport(), QPointF(115, 90));
  stage.settle();
  stage.picture("section_plane");
  stage.trigger("sectionPlane");
  stage.trigger("toolRuler");
  for (const Vector3& place : {Vector3(-60, -30, 80), Vector3(60, -30, 80)})
    test::click(stage.viewport(), stage.shownVertex(stage.nearestVertex(place)));
  stage.settle();
  stage.picture("ruler");
  stage.trigger("escape");
  stage.trigger("toolSelect");
}

}  // namespace

void looks(Stage& stage)
{
  stage.ask("help", [&](QWidget& dialog) { stage.pictureOf(dialog, "help"); });
  dark(stage);
  inside(stage);
  stage.open("bracket.obj", "bracket.constraints.json");
  stage.select("flange east");
  stage.resize(1024, 700);
  stage.trigger("frameAll");
  stage.picture("small_window");
  stage.raise("colorsDock");
  stage.raise("reportDock");
  stage.picture("small_window_with_other_panels");
  stage.raise("constraintsDock");
  stage.raise("inspectorDock");
  stage.resize(2560, 1440);
  stage.trigger("frameAll");
  stage.picture("large_window");
  stage.resize(1280, 800);
}

void glance(Stage& stage)
{
  stage.picture("empty_at_twice_the_scale");
  stage.openSession("bracket.holdfast");
  stage.select("flange east");
  stage.picture("bracket_at_twice_the_scale");
  stage.raise("colorsDock");
  stage.raise("reportDock");
  stage.picture("panels_at_twice_the_scale");
  stage.open("bar.obj", "bar.twist_360.constraints.json");
  stage.raise("sphereDock");
  stage.picture("rotations_at_twice_the_scale");
}

void postcards(Stage& stage)
{
  stage.resize(1200, 760);
  stage.openSession("bracket.holdfast");
  stage.trigger("frameAll");
  stage.select("flange east");
  stage.picture("window");
  stage.open("bar.obj", "bar.twist_360.constraints.json");
  stage.trigger("frameAll");
  stage.choose("colorField", static_cast<int>(ColorBy::Angle));
  stage.raise("sphereDock");
  stage.raise("reportDock");
  stage.picture("window_rotations");
}

}  // namespace holdfast::tour
