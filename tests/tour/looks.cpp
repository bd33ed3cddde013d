#include <QDialog>
#include <QLineEdit>
#include <QTreeWidget>

#include <holdfast/window/controls/theme.h>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {
namespace {

void dark(TourWindow& tour)
{
  apply(Appearance::Dark);
  tour.open("bracket.obj", "bracket.constraints.json");
  tour.select("flange east");
  tour.picture("dark");
  tour.trigger("toolProbe");
  test::click(tour.viewport(), tour.shownVertex(tour.nearestVertex(Vector3(0, -30, 70))));
  tour.raise("measuredDock");
  tour.settle();
  tour.picture("dark_measured");
  tour.trigger("removeMeasurements");
  tour.trigger("toolSelect");
  tour.open("bracket.obj", "bracket.conflict.constraints.json");
  tour.raise("conflictsDock");
  tour.raise("colorsDock");
  tour.picture("dark_conflicts_and_colours");
  tour.open("bar.obj", "bar.twist_360.constraints.json");
  tour.raise("sphereDock");
  tour.raise("reportDock");
  tour.picture("dark_rotations_and_report");
  tour.raise("histogramDock");
  tour.picture("dark_distributions");
  tour.trigger("close");
  tour.picture("dark_start_page");
  tour.raise("constraintsDock");
  tour.raise("inspectorDock");
  apply(Appearance::Light);
}

/// A cut through the mesh, and a distance on it.
void inside(TourWindow& tour)
{
  tour.open("bracket.obj", "bracket.constraints.json");
  tour.trigger("sectionPlane");
  test::moveMouse(tour.viewport(), QPointF(115, 90));
  tour.settle();
  tour.picture("section_plane");
  tour.trigger("sectionPlane");
  tour.trigger("toolRuler");
  for (const Vector3& place : {Vector3(-60, -30, 80), Vector3(60, -30, 80)})
    test::click(tour.viewport(), tour.shownVertex(tour.nearestVertex(place)));
  tour.settle();
  tour.picture("ruler");
  tour.trigger("toolProbe");
  test::click(tour.viewport(), tour.shownVertex(tour.nearestVertex(Vector3(0, -30, 70))));
  test::moveMouse(tour.viewport(), tour.shownVertex(tour.nearestVertex(Vector3(30, -30, 12))));
  tour.raise("measuredDock");
  tour.settle();
  tour.picture("measured");
  tour.raise("findingsDock");
  tour.trigger("showRest");
  tour.picture("mesh_at_rest");
  tour.trigger("showRest");
  tour.raise("inspectorDock");
  tour.trigger("removeMeasurements");
  tour.trigger("toolSelect");
}

/// Two that are saved, the second one selected; beside a ruler and probes.
void selections(TourWindow& tour)
{
  tour.editor().selectConstraints({});
  tour.raise("measuredDock");
  tour.clickVertices("toolRuler", {Vector3(-26, 10, 71), Vector3(26, 10, 71)});
  tour.clickVertices("toolProbe", {Vector3(0, 10, 70), Vector3(0, -30, 12)});
  for (const auto& [name, place] :
       {std::pair("pad", Vector3(0, -18, 15)), std::pair("right gusset", Vector3(29, 0, 24))}) {
    tour.clickVertices("toolFlood", {place});
    tour.trigger("saveSelection");
    auto* line = tour.find<QTreeWidget>("selectionTree").findChild<QLineEdit*>();
    require(line != nullptr, "the name of the new selection can be typed");
    line->setText(name);
    test::pressKey(*line, Qt::Key_Return);
    tour.settle();
  }
  test::moveMouse(tour.viewport(), QPointF(3, 3));
  tour.picture("window_selections");
  tour.trigger("removeMeasurements");
  tour.trigger("deselect");
  tour.trigger("toolSelect");
  tour.raise("constraintsDock");
}

}  // namespace

void looks(TourWindow& tour)
{
  for (const char* dialog : {"help", "commands", "preferences"})
    tour.ask(dialog, [&](QWidget& shown) { tour.pictureOf(shown, dialog); });
  dark(tour);
  inside(tour);
  tour.open("bracket.obj", "bracket.constraints.json");
  tour.select("flange east");
  tour.resize(1024, 700);
  tour.trigger("frameAll");
  tour.picture("small_window");
  tour.raise("colorsDock");
  tour.raise("reportDock");
  tour.picture("small_window_with_other_panels");
  tour.raise("constraintsDock");
  tour.raise("inspectorDock");
  tour.resize(2560, 1440);
  tour.trigger("frameAll");
  tour.picture("large_window");
  tour.resize(1280, 800);
}

void glance(TourWindow& tour)
{
  tour.picture("empty_at_twice_the_scale");
  tour.openSession("bracket.holdfast");
  tour.select("flange east");
  tour.picture("bracket_at_twice_the_scale");
  tour.raise("colorsDock");
  tour.raise("reportDock");
  tour.picture("panels_at_twice_the_scale");
  tour.open("bar.obj", "bar.twist_360.constraints.json");
  tour.raise("sphereDock");
  tour.picture("rotations_at_twice_the_scale");
}

void documentPictures(TourWindow& tour)
{
  tour.resize(1200, 760);
  tour.openSession("bracket.holdfast");
  tour.trigger("frameAll");
  tour.select("flange east");
  tour.picture("window");
  selections(tour);
  tour.open("bar.obj", "bar.twist_360.constraints.json");
  tour.trigger("frameAll");
  tour.choose("colorField", static_cast<int>(ColorBy::Angle));
  tour.raise("sphereDock");
  tour.raise("reportDock");
  tour.picture("window_rotations");
}

}  // namespace holdfast::tour
