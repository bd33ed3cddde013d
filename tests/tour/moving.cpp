#include <QTableView>

#include <holdfast/document/list_edits.h>
#include <holdfast/widgets/constraint_table_model.h>
#include <holdfast/widgets/tools/gizmo_tool.h>

#include "chapters.h"
#include "widgets/gestures.h"

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
  stage.select("crown top");
  stage.picture("inspector_of_a_point_on_an_edge");
  stage.open("bar.obj", "bar.twist_90.constraints.json");
  stage.select("top");
  stage.picture("inspector_of_a_handle");
}

}  // namespace holdfast::tour
