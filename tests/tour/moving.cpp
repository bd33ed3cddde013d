#include <QPushButton>
#include <QScrollArea>
#include <QTableView>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/table/constraint_table_model.h>
#include <holdfast/window/table/vertex_table_model.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "chapters.h"
#include "window/gestures.h"

namespace holdfast::tour {
namespace {

void dragArrow(TourWindow& tour)
{
  Viewport& viewport = tour.viewport();
  const QPointF from = tour.onArrow(1);
  const QPointF to = from + 1.2 * (tour.onArrow(1) - tour.shownAt(tour.window.gizmo().gizmo().GetFrame().center));
  test::moveMouse(viewport, from);
  test::pressMouse(viewport, from);
  for (int step = 1; step <= 10; ++step) {
    test::moveMouse(viewport, from + (to - from) * step / 10, Qt::LeftButton);
    tour.settle();
  }
  tour.picture("while_a_point_is_dragged");
  test::releaseMouse(viewport, to);
  tour.settle();
  tour.picture("dragged_point");
}

void typeAlongArrow(TourWindow& tour)
{
  Viewport& viewport = tour.viewport();
  test::moveMouse(viewport, tour.onArrow(1));
  test::type(viewport, "-12.5");
  tour.picture("length_typed_over_an_arrow");
  test::pressKey(viewport, Qt::Key_Return);
  tour.settle();
}

void pressButton(TourWindow& tour, const char* name)
{
  auto& button = tour.find<QPushButton>(name);
  test::click(button, QPointF(button.rect().center()));
  tour.settle();
}

/// Scrolls the inspector until all down to this can be seen.
void scrollTo(TourWindow& tour, const char* name)
{
  tour.find<QWidget>("inspectorPanel").findChild<QScrollArea*>()->ensureWidgetVisible(&tour.find<QWidget>(name));
}

/// Every part of it that a handle or a relative constraint has.
void inspect(TourWindow& tour)
{
  tour.select("crown top");
  tour.picture("inspector_of_a_point_on_an_edge");
  tour.choose("locationKind", 2);
  tour.picture("inspector_of_the_point_in_a_face");
  tour.open("bar.obj", "bar.twist_90.constraints.json");
  tour.select("top");
  tour.picture("inspector_of_a_handle");
  tour.choose("handleMethod", 3);
  tour.enter("frameTurns", "1");
  scrollTo(tour, "frameTurns");
  tour.picture("inspector_of_frames");
  // The handle once more, of listed vertices.
  pressButton(tour, "verticesSelect");
  tour.trigger("deleteConstraints");
  tour.trigger("makeHandle");
  tour.choose("handleMethod", 0);
  pressButton(tour, "vertexRotationsSwitch");
  tour.enterCell(tour.find<QTableView>("vertexRotations"), 1, VertexTableModel::Degrees, "33.3333333333");
  pressButton(tour, "vertexTargetsSwitch");
  scrollTo(tour, "vertexTargets");
  tour.picture("inspector_of_single_vertices");
  tour.open("head.ply", "head.rigid_eyes.constraints.json");
  tour.select("mouth to nose");
  tour.picture("inspector_of_a_relative_constraint");
}

}  // namespace

void moving(TourWindow& tour)
{
  tour.open("bracket.obj", "bracket.constraints.json");
  test::click(tour.viewport(), tour.shownMark("flange east"));
  tour.settle();
  tour.picture("selected_point_with_arrows");
  dragArrow(tour);
  tour.trigger("undo");
  tour.picture("undone");
  typeAlongArrow(tour);

  auto& table = tour.find<QTableView>("constraintTable");
  const auto row = static_cast<int>(indexOf(tour.editor().list(), "flange east").value());
  tour.enterCell(table, row, ConstraintTableModel::Y, "-2.5");
  tour.picture("typed_in_the_table");

  tour.raise("inspectorDock");
  inspect(tour);
}

}  // namespace holdfast::tour
