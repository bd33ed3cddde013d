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

void dragArrow(Stage& stage)
{
  Viewport& viewport = stage.viewport();
  const QPointF from = stage.shownArrow(1);
  const QPointF to = from + 1.2 * (stage.shownArrow(1) - stage.shown(stage.window().gizmo().gizmo().GetFrame().center));
  test::moveMouse(viewport, from);
  test::pressMouse(viewport, from);
  for (int step = 1; step <= 10; ++step) {
    test::moveMouse(viewport, from + (to - from) * step / 10, Qt::LeftButton);
    stage.settle();
  }
  stage.picture("while_a_point_is_dragged");
  test::releaseMouse(viewport, to);
  stage.settle();
  stage.picture("dragged_point");
}

void typeAlongArrow(Stage& stage)
{
  Viewport& viewport = stage.viewport();
  test::moveMouse(viewport, stage.shownArrow(1));
  test::type(viewport, "-12.5");
  stage.picture("length_typed_over_an_arrow");
  test::pressKey(viewport, Qt::Key_Return);
  stage.settle();
}

void pressButton(Stage& stage, const char* name)
{
  auto& button = stage.find<QPushButton>(name);
  test::click(button, QPointF(button.rect().center()));
  stage.settle();
}

/// Scrolls the inspector until all down to this can be seen.
void scrollTo(Stage& stage, const char* name)
{
  stage.find<QWidget>("inspectorPanel").findChild<QScrollArea*>()->ensureWidgetVisible(&stage.find<QWidget>(name));
}

/// Every part of it that a handle or a relative constraint has.
void inspect(Stage& stage)
{
  stage.select("crown top");
  stage.picture("inspector_of_a_point_on_an_edge");
  stage.choose("locationKind", 2);
  stage.picture("inspector_of_the_point_in_a_face");
  stage.open("bar.obj", "bar.twist_90.constraints.json");
  stage.select("top");
  stage.picture("inspector_of_a_handle");
  stage.choose("handleMethod", 3);
  stage.enter("frameTurns", "1");
  scrollTo(stage, "frameTurns");
  stage.picture("inspector_of_frames");
  // The handle once more, of listed vertices.
  pressButton(stage, "verticesSelect");
  stage.trigger("deleteConstraints");
  stage.trigger("makeHandle");
  stage.choose("handleMethod", 0);
  pressButton(stage, "vertexRotationsSwitch");
  stage.enterCell(stage.find<QTableView>("vertexRotations"), 1, VertexTableModel::Degrees, "33.3333333333");
  pressButton(stage, "vertexTargetsSwitch");
  scrollTo(stage, "vertexTargets");
  stage.picture("inspector_of_single_vertices");
  stage.open("head.ply", "head.rigid_eyes.constraints.json");
  stage.select("mouth to nose");
  stage.picture("inspector_of_a_relative_constraint");
}

}  // namespace

void moving(Stage& stage)
{
  stage.open("bracket.obj", "bracket.constraints.json");
  test::click(stage.viewport(), stage.shownMark("flange east"));
  stage.settle();
  stage.picture("selected_point_with_arrows");
  dragArrow(stage);
  stage.trigger("undo");
  stage.picture("undone");
  typeAlongArrow(stage);

  auto& table = stage.find<QTableView>("constraintTable");
  const auto row = static_cast<int>(indexOf(stage.editor().list(), "flange east").value());
  stage.enterCell(table, row, ConstraintTableModel::Y, "-2.5");
  stage.picture("typed_in_the_table");

  stage.raise("inspectorDock");
  inspect(stage);
}

}  // namespace holdfast::tour
