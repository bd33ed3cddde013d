#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QScrollBar>
#include <QTableView>
#include <QTextDocument>
#include <QToolTip>
#include <memory>

#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/io/text/number_text.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/table/constraint_table.h>
#include <holdfast/window/table/constraint_table_model.h>

#include "gestures.h"
#include "open_document.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;

/// A flat sheet of 10 x 10 squares, its left border fixed, with points of all kinds.
ConstraintList sheetList()
{
  const Vector3 up(0, 0, 0.1);
  ConstraintList list{"mm", {}};
  list.constraints = {
      {"base", true, FixedConstraint{{InHalfSpace{Vector3(0.5, 0, 0), Vector3(-1, 0, 0)}}}},
      {"P1", true, PointConstraint{AtVertex{36}, Target{Vector3(3, 2, 1)}}},
      {"P2", true, PointConstraint{AtEdge{44, 45, 0.25}, Move{up}}},
      {"P3", true, PointConstraint{AtFace{77, {0.2, 0.3, 0.5}}, Move{up}}},
      {"P10", true, PointConstraint{AtNear{Vector3(8.1, 6.2, 3)}, Target{Vector3(8.1, 6.2, 0.5)}}},
      {"tip", true, HandleConstraint{{VertexIds{{118, 119, 120}}}, {}, Vector3(0, 0, 2), {}}},
  };
  return list;
}

class ConstraintPanelOfSheet : public ::testing::Test {
 protected:
  void SetUp() override
  {
    ASSERT_TRUE(test::openMesh(editor, test::grid(10, 10), sheetList()));
    panel.resize(1100, 500);
    ASSERT_TRUE(test::showAndWait(panel));
  }

  [[nodiscard]] QTableView& table() { return *panel.findChild<QTableView*>("constraintTable"); }
  [[nodiscard]] QAbstractItemModel& rows() { return *table().model(); }
  [[nodiscard]] QString shown(int row, int column) { return rows().index(row, column).data().toString(); }
  [[nodiscard]] std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const Constraint& constraint : editor.list().constraints) result.push_back(constraint.name);
    return result;
  }
  [[nodiscard]] QStringList shownNames()
  {
    QStringList result;
    for (int row = 0; row < rows().rowCount(); ++row) result << shown(row, Table::Name);
    return result;
  }
  [[nodiscard]] const PointConstraint& point(const char* name) const
  {
    return std::get<PointConstraint>(editor.list().constraints[indexOf(editor.list(), name).value()].what);
  }
  [[nodiscard]] QPointF middleOf(int row, int column)
  {
    table().scrollTo(rows().index(row, column));
    return table().visualRect(rows().index(row, column)).center();
  }
  void clickCell(int row, int column, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    test::click(*table().viewport(), middleOf(row, column), Qt::LeftButton, modifiers);
  }
  /// Types into a cell of the current row as a user does: F2, the text, Enter.
  void typeInto(int row, int column, const char* text)
  {
    table().selectionModel()->setCurrentIndex(rows().index(row, column), QItemSelectionModel::NoUpdate);
    test::pressKey(table(), Qt::Key_F2);
    QLineEdit* line = table().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr) << "the cell cannot be edited";
    line->selectAll();
    test::type(*line, text);
    test::pressKey(*line, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return table().viewport()->findChild<QLineEdit*>() == nullptr; }));
  }
  [[nodiscard]] QLabel& refusal() { return *panel.findChild<QLabel*>("constraintRefusal"); }

  Editor editor;
  std::unique_ptr<QWidget> constraints{newConstraintPanel(editor, [](Index) {})};
  QWidget& panel = *constraints;
};

TEST_F(ConstraintPanelOfSheet, TellsWhatEachConstraintIs)
{
  EXPECT_EQ(shown(1, Table::Where), "vertex 36");
  EXPECT_EQ(shown(2, Table::Where), "edge 44–45, t 0.25");
  EXPECT_EQ(shown(3, Table::Where), "face 77: 0.2, 0.3, 0.5");
  EXPECT_EQ(shown(4, Table::Where), "near (8.1, 6.2, 3)");
  EXPECT_EQ(shown(5, Table::Where), "3 vertices");
  EXPECT_EQ(shown(5, Table::Kind), "handle");
  EXPECT_EQ(shown(5, Table::Z), "2");
  EXPECT_EQ(shown(0, Table::X), "");
  EXPECT_EQ(shown(1, Table::Status), "met");
}

TEST_F(ConstraintPanelOfSheet, RoundingIsShownAsZeroAndNothingIsMinusZero)
{
  ConstraintList list = editor.list();
  std::get<HandleConstraint>(list.constraints[5].what).translate = Vector3(3.469e-17, -0.0, 1e-9);
  editor.edit("move", list);
  EXPECT_EQ(shown(5, Table::X), "0");
  EXPECT_EQ(shown(5, Table::Y), "0");
  EXPECT_EQ(shown(5, Table::Z), "1e-09");
}

TEST_F(ConstraintPanelOfSheet, SwitchAndNameStayInSightWhenTheRestIsScrolled)
{
  panel.resize(400, 500);
  const auto shownAt = [this](int column) {
    const QPoint place = table().viewport()->mapTo(&table(), QPoint(4, 4)) + QPoint(column == Table::On ? 0 : 40, 0);
    const auto* over = qobject_cast<QTableView*>(table().childAt(place)->parentWidget());
    return over->indexAt(over->viewport()->mapFrom(&table(), place)).column();
  };
  EXPECT_EQ(shownAt(Table::Name), Table::Name);
  table().scrollTo(rows().index(0, Table::Force));
  ASSERT_GT(table().horizontalScrollBar()->value(), 100);
  EXPECT_EQ(shownAt(Table::On), Table::On);
  EXPECT_EQ(shownAt(Table::Name), Table::Name);
  auto& pinned = *qobject_cast<QTableView*>(table().childAt(table().viewport()->pos() + QPoint(40, 4))->parentWidget());
  ASSERT_NE(&pinned, &table());
  test::click(*pinned.viewport(), pinned.visualRect(rows().index(2, Table::Name)).center());
  EXPECT_EQ(editor.selectedConstraints(), (Rows{2}));
  // Cells that the keys go to are not behind them.
  table().selectionModel()->setCurrentIndex(rows().index(2, Table::X), QItemSelectionModel::NoUpdate);
  table().scrollTo(rows().index(2, Table::X));
  EXPECT_GE(table().visualRect(rows().index(2, Table::X)).left(), pinned.isVisible() ? pinned.width() : 0);
}

TEST_F(ConstraintPanelOfSheet, ANarrowColumnHasFewerDigitsAndCutsNoNumber)
{
  ConstraintList list = editor.list();
  const auto setX = [&](Index row, double x) {
    std::get<Target>(std::get<PointConstraint>(list.constraints[row].what).to).place.x() = x;
  };
  setX(1, 0.0995432);
  setX(4, 0.0995);
  editor.edit("move", list);
  const auto drawn = [this](int row) {
    return table().viewport()->grab(table().visualRect(rows().index(row, Table::X))).toImage();
  };
  table().setAlternatingRowColors(false);
  table().setColumnWidth(Table::X, table().fontMetrics().horizontalAdvance("0.0995") + 10);
  EXPECT_EQ(drawn(1), drawn(4)) << "three digits";
  table().setColumnWidth(Table::X, table().fontMetrics().horizontalAdvance("0.099543") + 10);
  EXPECT_NE(drawn(1), drawn(4)) << "five digits";
}

TEST_F(ConstraintPanelOfSheet, ColumnsAreChosen)
{
  auto* action = panel.findChild<QAction*>("columnForce");
  ASSERT_FALSE(table().isColumnHidden(Table::Force));
  action->trigger();
  EXPECT_TRUE(table().isColumnHidden(Table::Force));
  action->trigger();
  EXPECT_FALSE(table().isColumnHidden(Table::Force));
}

TEST_F(ConstraintPanelOfSheet, ARefusalMovesNoRow)
{
  const QPoint before = table().viewport()->mapToGlobal(table().visualRect(rows().index(3, Table::X)).topLeft());
  typeInto(3, Table::X, "a");
  QApplication::processEvents();
  ASSERT_TRUE(refusal().isVisible());
  EXPECT_EQ(table().viewport()->mapToGlobal(table().visualRect(rows().index(3, Table::X)).topLeft()), before);
}

TEST_F(ConstraintPanelOfSheet, ATypedTargetIsTheTargetToTheLastBit)
{
  typeInto(1, Table::X, "0.1000000000000000055511151231257827");
  EXPECT_TRUE(hasSameBits(std::get<Target>(point("P1").to).place.x(), 0.1));
  EXPECT_EQ(std::get<Target>(point("P1").to).place.tail<2>(), Eigen::Vector2d(2, 1));
  EXPECT_EQ(editor.history().undoName(), "move P1 to x = 0.1");
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_TRUE(hasSameBits(editor.positions()(36, 0), 0.1)) << "and the vertex lies there";
}

TEST_F(ConstraintPanelOfSheet, AShiftShowsItsTargetAndLandsWhereTyped)
{
  // 0.1 above a point whose weights make it no round number.
  typeInto(3, Table::Z, "0.7");
  const DeformResult& before = *editor.deformation();
  const double rest = positionOf(before.details->system.points[3], editor.model()->mesh.positions).z();
  const PointConstraint& after = point("P3");
  const double lands = std::holds_alternative<Move>(after.to) ? rest + std::get<Move>(after.to).shift.z()
                                                              : std::get<Target>(after.to).place.z();
  EXPECT_TRUE(hasSameBits(lands, 0.7));
  EXPECT_EQ(rows().index(3, Table::Z).data(Qt::EditRole).toString(), "0.7");
}

TEST_F(ConstraintPanelOfSheet, WhatIsNoNumberIsRefusedWithTheReason)
{
  const auto before = editor.history().state();
  typeInto(1, Table::X, "1,5");
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_TRUE(refusal().isVisible());
  EXPECT_TRUE(refusal().text().contains("point")) << refusal().text().toStdString();
  typeInto(1, Table::X, "1.5");
  EXPECT_FALSE(refusal().isVisible());
}

TEST_F(ConstraintPanelOfSheet, TypingWhatIsThereMakesNoEntryOfTheHistory)
{
  typeInto(1, Table::X, "3.0");
  EXPECT_FALSE(editor.history().canUndo());
}

TEST_F(ConstraintPanelOfSheet, AnEditOfOneCellGoesToAllSelectedRows)
{
  clickCell(1, Table::Name);
  clickCell(3, Table::Name, Qt::ControlModifier);
  clickCell(5, Table::Name, Qt::ControlModifier);
  typeInto(3, Table::Z, "-0.3");
  EXPECT_EQ(rows().index(1, Table::Z).data(Qt::EditRole).toString(), "-0.3");
  EXPECT_EQ(rows().index(2, Table::Z).data(Qt::EditRole).toString(), "0.1");
  EXPECT_EQ(rows().index(3, Table::Z).data(Qt::EditRole).toString(), "-0.3");
  EXPECT_EQ(rows().index(5, Table::Z).data(Qt::EditRole).toString(), "-0.3");
  editor.undo();
  EXPECT_FALSE(editor.history().canUndo()) << "one entry";
}

TEST_F(ConstraintPanelOfSheet, ACheckBoxSwitchesAllSelectedRowsAndKeepsThemSelected)
{
  clickCell(1, Table::Name);
  clickCell(3, Table::Name, Qt::ShiftModifier);
  const QRect cell = table().visualRect(rows().index(2, Table::On));
  test::click(*table().viewport(), QPointF(cell.left() + cell.height() / 2.0, cell.center().y()));
  for (Index k = 0; k < 6; ++k) EXPECT_EQ(editor.list().constraints[k].isEnabled, k < 1 || k > 3) << "constraint " << k;
  EXPECT_EQ(editor.selectedConstraints(), (Rows{1, 2, 3}));
  EXPECT_EQ(shown(2, Table::Status), "disabled") << "at once, before anything is solved";
}

TEST_F(ConstraintPanelOfSheet, SelectionIsThatOfTheEditorBothWays)
{
  int told = 0;
  QObject::connect(&editor, &Editor::constraintSelectionChanged, &panel, [&] { ++told; });
  clickCell(4, Table::Name);
  EXPECT_EQ(editor.selectedConstraints(), (Rows{4}));
  EXPECT_EQ(told, 1) << "no echo";
  editor.selectConstraints({0, 1, 5});
  EXPECT_EQ(told, 2);
  const QModelIndexList selected = table().selectionModel()->selectedRows();
  ASSERT_EQ(selected.size(), 3);
  EXPECT_EQ(selected.back().row(), 5);
}

TEST_F(ConstraintPanelOfSheet, RowsMoveByKeysAndKeepTheirSelection)
{
  clickCell(2, Table::Name);
  test::pressKey(table(), Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(names(), (std::vector<std::string>{"base", "P2", "P1", "P3", "P10", "tip"}));
  EXPECT_EQ(editor.selectedConstraints(), (Rows{1}));
  test::pressKey(table(), Qt::Key_Down, Qt::AltModifier);
  test::pressKey(table(), Qt::Key_Down, Qt::AltModifier);
  EXPECT_EQ(names(), (std::vector<std::string>{"base", "P1", "P3", "P2", "P10", "tip"}));
}

TEST_F(ConstraintPanelOfSheet, DroppedRowsChangeThePrecedence)
{
  clickCell(1, Table::Name);
  clickCell(3, Table::Name, Qt::ControlModifier);
  const std::unique_ptr<QMimeData> dragged(rows().mimeData(table().selectionModel()->selectedIndexes()));
  const QRect last = table().visualRect(rows().index(5, Table::Name));
  const QPoint below(last.center().x(), last.bottom());
  QDragEnterEvent enter(below, Qt::MoveAction, dragged.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(table().viewport(), &enter);
  QDragMoveEvent over(below, Qt::MoveAction, dragged.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(table().viewport(), &over);
  EXPECT_TRUE(over.isAccepted());
  QDropEvent drop(below, Qt::MoveAction, dragged.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(table().viewport(), &drop);
  EXPECT_EQ(names(), (std::vector<std::string>{"base", "P2", "P10", "tip", "P1", "P3"}));
  EXPECT_EQ(editor.selectedConstraints(), (Rows{4, 5}));
}

TEST_F(ConstraintPanelOfSheet, TheThirdClickOnATitleReturnsToThePrecedence)
{
  QHeaderView& header = *table().horizontalHeader();
  const QPointF title(header.sectionViewportPosition(Table::Name) + 20, header.height() / 2.0);
  test::click(*header.viewport(), title);
  EXPECT_EQ(shownNames(), (QStringList{"base", "P1", "P2", "P3", "P10", "tip"})) << "numbers in names count as numbers";
  EXPECT_FALSE(rows().flags(rows().index(0, 0)) & Qt::ItemIsDragEnabled);
  test::click(*header.viewport(), title);
  EXPECT_EQ(shownNames(), (QStringList{"tip", "P10", "P3", "P2", "P1", "base"}));
  EXPECT_EQ(rows().headerData(0, Qt::Vertical).toInt(), 6) << "the place in the order of precedence";
  test::click(*header.viewport(), title);
  EXPECT_EQ(shownNames(), (QStringList{"base", "P1", "P2", "P3", "P10", "tip"}));
  EXPECT_TRUE(rows().flags(rows().index(0, 0)) & Qt::ItemIsDragEnabled);
}

TEST_F(ConstraintPanelOfSheet, MissingNumbersComeLastInBothDirections)
{
  QHeaderView& header = *table().horizontalHeader();
  const QPointF title(header.sectionViewportPosition(Table::Z) + 20, header.height() / 2.0);
  test::click(*header.viewport(), title);
  EXPECT_EQ(shownNames().front(), "P2");
  EXPECT_EQ(shownNames().back(), "base");
  test::click(*header.viewport(), title);
  EXPECT_EQ(shownNames().front(), "tip");
  EXPECT_EQ(shownNames().back(), "base");
}

TEST_F(ConstraintPanelOfSheet, FiltersByTextAndStatus)
{
  QLineEdit& text = *panel.findChild<QLineEdit*>("constraintFilter");
  editor.selectConstraints({1, 5});
  test::type(text, "p 1");
  EXPECT_EQ(shownNames(), (QStringList{"P1", "P10"})) << "every word, in name, kind or place";
  text.clear();
  test::type(text, "edge");
  EXPECT_EQ(shownNames(), (QStringList{"P2"}));
  EXPECT_TRUE(editor.selectedConstraints().empty()) << "what is hidden is not edited unseen";
  text.clear();
  switchConstraints(editor, {3}, Enabling::Disabled);
  QComboBox& status = *panel.findChild<QComboBox*>("constraintStatusFilter");
  status.setCurrentIndex(status.findText("Disabled"));
  EXPECT_EQ(shownNames(), (QStringList{"P3"}));
}

TEST_F(ConstraintPanelOfSheet, ANameIsShownOnOneLineAndEditedAsItIs)
{
  const std::string name = "P\n\x1B\xE2\x80\xAE" + std::string(1000, 'x');
  renameConstraint(editor, 1, QString::fromStdString(name));
  EXPECT_TRUE(shown(1, Table::Name).startsWith(R"(P\x0a\x1b\xe2\x80\xaexxx)"));
  EXPECT_EQ(rows().index(1, Table::Name).data(Qt::EditRole).toString().toStdString(), name);
  switchConstraints(editor, {1}, Enabling::Disabled);
  const std::string undo(editor.history().undoName());
  EXPECT_LT(undo.size(), 100U) << "menus stay narrow";
  EXPECT_TRUE(undo.starts_with(R"(disable P\x0a)")) << undo;
}

TEST_F(ConstraintPanelOfSheet, ANameThatLooksLikeHtmlIsShownAsItIsTyped)
{
  typeInto(1, Table::Name, "<b>x</b>");
  EXPECT_EQ(shown(1, Table::Name), "<b>x</b>");
  const QModelIndex cell = rows().index(1, Table::Name);
  const QPoint place = table().visualRect(cell).center();
  QHelpEvent asks(QEvent::ToolTip, place, table().viewport()->mapToGlobal(place));
  QApplication::sendEvent(table().viewport(), &asks);
  ASSERT_TRUE(test::waitUntil([] { return QToolTip::isVisible(); }));
  QTextDocument shownTip;
  shownTip.setHtml(QToolTip::text());
  EXPECT_EQ(shownTip.toPlainText(), "<b>x</b>");
  QToolTip::hideText();
}

TEST_F(ConstraintPanelOfSheet, ATakenNameIsRefusedWithTheReason)
{
  typeInto(1, Table::Name, "P2");
  EXPECT_EQ(editor.list().constraints[1].name, "P1");
  EXPECT_TRUE(refusal().isVisible());
  EXPECT_TRUE(refusal().text().contains("P2")) << refusal().text().toStdString();
  typeInto(1, Table::Name, "nose");
  EXPECT_EQ(editor.list().constraints[1].name, "nose");
  EXPECT_EQ(editor.history().undoName(), "rename P1 to nose");
  EXPECT_FALSE(refusal().isVisible());
}

TEST_F(ConstraintPanelOfSheet, CopiedPointsComeBackFromTheirTableBitForBit)
{
  clickCell(1, Table::Name);
  clickCell(3, Table::Name, Qt::ControlModifier);
  test::pressKey(table(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith("name,x,y,z,target_x,target_y,target_z\n"));
  test::pressKey(table(), Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(editor.list().constraints.size(), 8U);
  EXPECT_EQ(editor.selectedConstraints(), (Rows{6, 7}));
  EXPECT_EQ(std::get<Target>(std::get<PointConstraint>(editor.list().constraints[6].what).to).place, Vector3(3, 2, 1));
  for (const int column : {Table::X, Table::Y, Table::Z})
    EXPECT_EQ(rows().index(7, column).data(Qt::EditRole), rows().index(3, column).data(Qt::EditRole));
  EXPECT_NE(shown(6, Table::Name), "P1") << "names stay unique";
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_EQ(shown(6, Table::Status), "redundant") << "it lies where the copied point does";
}

TEST_F(ConstraintPanelOfSheet, OtherKindsAreCopiedWhole)
{
  clickCell(5, Table::Name);
  test::pressKey(table(), Qt::Key_C, Qt::ControlModifier);
  test::pressKey(table(), Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(editor.list().constraints.size(), 7U);
  const HandleConstraint& copy = std::get<HandleConstraint>(editor.list().constraints[6].what);
  EXPECT_EQ(std::get<VertexIds>(copy.select.what).ids, (std::vector<Index>{118, 119, 120}));
  EXPECT_EQ(copy.translate, Vector3(0, 0, 2));
}

TEST_F(ConstraintPanelOfSheet, PastingWhatIsNoListIsRefusedWithTheReason)
{
  const auto before = editor.history().state();
  QApplication::clipboard()->setText("no list at all");
  test::pressKey(table(), Qt::Key_V, Qt::ControlModifier);
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_TRUE(refusal().isVisible());
}

TEST_F(ConstraintPanelOfSheet, DeletedRowsGoAndTheNextOneIsSelected)
{
  clickCell(1, Table::Name);
  clickCell(2, Table::Name, Qt::ControlModifier);
  test::pressKey(table(), Qt::Key_Delete);
  EXPECT_EQ(names(), (std::vector<std::string>{"base", "P3", "P10", "tip"}));
  EXPECT_EQ(shownNames(), (QStringList{"base", "P3", "P10", "tip"}));
  EXPECT_EQ(editor.selectedConstraints(), (Rows{1}));
  editor.undo();
  EXPECT_EQ(names().size(), 6U);
}

TEST_F(ConstraintPanelOfSheet, DuplicatesHaveNamesOfTheirOwn)
{
  clickCell(2, Table::Name);
  test::pressKey(table(), Qt::Key_D, Qt::ControlModifier);
  ASSERT_EQ(names().size(), 7U);
  EXPECT_NE(names()[6], "P2");
  EXPECT_TRUE(std::holds_alternative<AtEdge>(std::get<PointConstraint>(editor.list().constraints[6].what).at));
}

TEST_F(ConstraintPanelOfSheet, ResultsOfAnOlderListAreGrey)
{
  EXPECT_FALSE(rows().index(1, Table::Residual).data(Qt::ForegroundRole).isValid());
  editor.edit("move", withEnabled(editor.list(), {3}, Enabling::Disabled));
  EXPECT_TRUE(rows().index(1, Table::Residual).data(Qt::ForegroundRole).isValid()) << "while it is solved";
  editor.cancelSolving();
  EXPECT_TRUE(rows().index(1, Table::Residual).data(Qt::ForegroundRole).isValid());
  EXPECT_FALSE(rows().index(1, Table::X).data(Qt::ForegroundRole).isValid());
  editor.solve();
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_FALSE(rows().index(1, Table::Residual).data(Qt::ForegroundRole).isValid());
}

TEST_F(ConstraintPanelOfSheet, TenThousandRowsAreShownFilteredAndSortedFluently)
{
  ConstraintList many = sheetList();
  for (int k = 0; k < 10'000; ++k)
    many.constraints.push_back(
        {"M" + std::to_string(k), true, PointConstraint{AtVertex{36}, Target{Vector3(3, 2, 1)}}});
  editor.edit("add", many);
  QElapsedTimer timer;
  timer.start();
  test::type(*panel.findChild<QLineEdit*>("constraintFilter"), "M77");
  EXPECT_EQ(rows().rowCount(), 111);
  panel.findChild<QLineEdit*>("constraintFilter")->clear();
  test::pressKey(table(), Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(editor.selectedConstraints().size(), 10'006U);
  QHeaderView& header = *table().horizontalHeader();
  test::click(*header.viewport(), QPointF(header.sectionViewportPosition(Table::Where) + 20, header.height() / 2.0));
  EXPECT_EQ(shown(0, Table::Where), "3 vertices");
  // A tenth of a second; many where each row has a widget, or is told of on its own.
  EXPECT_LT(timer.elapsed(), 5000);
}

TEST_F(ConstraintPanelOfSheet, AnEmptyTableSaysWhatToDo)
{
  editor.edit("delete all", {});
  EXPECT_EQ(rows().rowCount(), 0);
  editor.close();
  EXPECT_EQ(rows().rowCount(), 0);
  EXPECT_TRUE(panel.findChild<QLabel*>("constraintCount")->text().startsWith('0'));
}

}  // namespace
}  // namespace holdfast
