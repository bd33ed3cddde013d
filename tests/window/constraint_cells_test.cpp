// Cells: what they show, and what is typed into them.

#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QScrollBar>
#include <QTextDocument>
#include <QToolTip>
#include <set>

#include <holdfast/deform/deform_details.h>
#include <holdfast/numbers/same_bits.h>
#include <holdfast/window/model/constraint_actions.h>

#include "sheet_panel.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;
using test::ConstraintPanelOfSheet;

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

TEST_F(ConstraintPanelOfSheet, FreeCoordinatesAreEmptyAndHeldOnesAreTyped)
{
  ConstraintList list = editor.list();
  auto& coordinates = std::get<PointConstraint>(list.constraints[1].what).to.emplace<Coordinates>();
  coordinates.values = {1.5, std::nullopt, 0.25};
  std::get<PointConstraint>(list.constraints[2].what).to = OnPlane{Vector3(0, 0, 0.5), {0, 0, 3}, 0};
  editor.edit("let them slide", list);
  EXPECT_EQ(shown(1, Table::X), "1.5");
  EXPECT_EQ(shown(1, Table::Y), "");
  EXPECT_FALSE(rows().flags(rows().index(1, Table::Y)) & Qt::ItemIsEditable);
  EXPECT_EQ(shown(2, Table::X), "");
  EXPECT_EQ(shown(2, Table::Z), "0.5");
  typeInto(1, Table::Z, "0.75");
  EXPECT_EQ(std::get<Coordinates>(point("P1").to).values[2], 0.75);
  typeInto(2, Table::Z, "0.625");
  EXPECT_EQ(std::get<OnPlane>(point("P2").to).point->z(), 0.625);
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

TEST_F(ConstraintPanelOfSheet, AResidualWithinItsLimitReadsMet)
{
  const ConstraintOutcome& outcome = *editor.outcome(editor.list().constraints[1].name, 1);
  EXPECT_EQ(shown(1, Table::Residual), metText(*outcome.limit, ""));
  const QString tip = rows().index(1, Table::Residual).data(Qt::ToolTipRole).toString();
  EXPECT_TRUE(tip.contains(exactText(*outcome.residual))) << tip.toStdString();
  EXPECT_TRUE(tip.contains(exactText(*outcome.limit))) << tip.toStdString();
}

TEST_F(ConstraintPanelOfSheet, AResidualBeyondItsLimitKeepsItsDigits)
{
  DeformOptions options = editor.state().options;
  options.solver.kind = SolverKind::Soft;
  editor.setOptions("soft", options);
  ASSERT_TRUE(test::waitForCurrent(editor));
  const ConstraintOutcome& outcome = *editor.outcome(editor.list().constraints[1].name, 1);
  ASSERT_EQ(outcome.status, ConstraintStatus::Missed);
  EXPECT_EQ(shown(1, Table::Residual), shortText(*outcome.residual));
}

TEST_F(ConstraintPanelOfSheet, TargetsHaveTheDecimalsOfTheDocument)
{
  const QString before = shown(1, Table::Z);
  editor.setDecimals(3);
  EXPECT_EQ(shown(5, Table::Z), "2.000");
  EXPECT_EQ(rows().index(5, Table::Z).data(Qt::EditRole).toString(), "2") << "what is typed has all digits";
  editor.setDecimals(std::nullopt);
  EXPECT_EQ(shown(1, Table::Z), before);
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
  const PointConstraint& after = point("P3");
  const Model& model = *editor.model();
  const double rest = positionOf(model.locator().locate(after.at, {}), model.mesh.positions).z();
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

TEST_F(ConstraintPanelOfSheet, ARefusalGoesWhenTheCellIsRight)
{
  typeInto(1, Table::X, "abc");
  ASSERT_TRUE(refusal().isVisible());
  typeInto(1, Table::X, "3");
  EXPECT_FALSE(refusal().isVisible()) << "it was 3 before";
  typeInto(1, Table::X, "abc");
  ASSERT_TRUE(refusal().isVisible());
  test::pressKey(table(), Qt::Key_F2);
  test::pressKey(*table().viewport()->findChild<QLineEdit*>(), Qt::Key_Escape);
  EXPECT_FALSE(refusal().isVisible()) << "what was there stays";
  ASSERT_TRUE(test::waitUntil([&] { return table().viewport()->findChild<QLineEdit*>() == nullptr; }));
  typeInto(1, Table::Name, "P2");
  ASSERT_TRUE(refusal().isVisible()) << "the name is taken";
  typeInto(1, Table::Name, "P1");
  EXPECT_FALSE(refusal().isVisible());
}

TEST_F(ConstraintPanelOfSheet, TheFirstCharacterOfANumberEditsItsCell)
{
  const auto typeAtOnce = [this](int row, int column, const char* text) {
    table().selectionModel()->setCurrentIndex(rows().index(row, column), QItemSelectionModel::NoUpdate);
    table().setFocus();
    test::type(table(), std::string(1, text[0]).c_str());
    auto* line = table().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr) << text;
    EXPECT_EQ(table().currentIndex(), rows().index(row, column)) << "the row stays";
    test::type(*line, text + 1);
    test::pressKey(*line, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return table().viewport()->findChild<QLineEdit*>() == nullptr; }));
    EXPECT_EQ(table().currentIndex(), rows().index(row, column));
  };
  typeAtOnce(1, Table::X, "4.25");
  EXPECT_EQ(std::get<Target>(point("P1").to).place.x(), 4.25);
  typeAtOnce(1, Table::Y, "-2");
  EXPECT_EQ(std::get<Target>(point("P1").to).place.y(), -2);
  typeAtOnce(1, Table::Z, ".5");
  EXPECT_EQ(std::get<Target>(point("P1").to).place.z(), 0.5);
}

TEST_F(ConstraintPanelOfSheet, DigitsBesideNumbersLeaveTheRow)
{
  // A fixed region has no target; residuals cannot be typed.
  for (const auto& [row, column] :
       {std::pair(0, static_cast<int>(Table::X)), {1, Table::Residual}, {2, Table::Where}}) {
    table().selectionModel()->setCurrentIndex(rows().index(row, column), QItemSelectionModel::NoUpdate);
    for (const char* text : {"8", "0", "3"}) test::type(table(), text);
    EXPECT_EQ(table().currentIndex(), rows().index(row, column));
  }
  table().selectionModel()->setCurrentIndex(rows().index(0, Table::Name), QItemSelectionModel::NoUpdate);
  test::type(table(), "t");
  EXPECT_EQ(table().currentIndex().row(), 5) << "names are found by their letters";
}

TEST_F(ConstraintPanelOfSheet, ARowThatIsSortedElsewhereStaysInSight)
{
  ConstraintList list = editor.list();
  for (int k = 0; k < 60; ++k)
    list.constraints.push_back({"Q" + std::to_string(k), true, PointConstraint{AtVertex{k}, Target{Vector3(k, 0, 0)}}});
  editor.edit("add", list);
  ASSERT_TRUE(test::waitForCurrent(editor));
  QHeaderView& header = *table().horizontalHeader();
  test::click(*header.viewport(), QPointF(header.sectionViewportPosition(Table::X) + 20, header.height() / 2.0));
  const int first =
      rows().match(rows().index(0, Table::Name), Qt::DisplayRole, "Q1", 1, Qt::MatchExactly).front().row();
  typeInto(first, Table::X, "1000");
  EXPECT_EQ(table().currentIndex().siblingAtColumn(Table::Name).data().toString(), "Q1");
  EXPECT_TRUE(table().viewport()->rect().contains(table().visualRect(table().currentIndex()).center()));
}

TEST_F(ConstraintPanelOfSheet, ANumberIsNeverCutAtTheEdgeOfTheTable)
{
  ConstraintList list = editor.list();
  std::get<Target>(std::get<PointConstraint>(list.constraints[1].what).to).place.x() = 55.673;
  editor.edit("move", list);
  panel.resize(420, 500);
  ASSERT_TRUE(test::waitUntil([&] { return table().horizontalScrollBar()->maximum() > 0; }));
  table().setAlternatingRowColors(false);
  // A cell of which a part is seen looks as one that is as narrow as that part, whichever side is hidden.
  auto& whole = static_cast<ConstraintTable&>(table());
  const QModelIndex cell = rows().index(1, Table::X);
  std::set<int> widths;
  for (int scrolled = 0; scrolled <= table().horizontalScrollBar()->maximum(); scrolled += 3) {
    table().horizontalScrollBar()->setValue(scrolled);
    const QRect seen = whole.seenPart(table().visualRect(cell));
    if (seen.width() < table().horizontalHeader()->minimumSectionSize() ||
        seen.width() >= table().visualRect(cell).width())
      continue;
    widths.insert(seen.width());
    const QImage part = table().viewport()->grab(seen).toImage();
    const int all = table().columnWidth(Table::X);
    table().horizontalScrollBar()->setValue(0);
    table().setColumnWidth(Table::X, seen.width());
    table().scrollTo(cell);
    const QRect narrow = table().visualRect(cell);
    EXPECT_EQ(table().viewport()->grab(narrow).toImage(), part) << seen.width();
    table().setColumnWidth(Table::X, all);
  }
  EXPECT_GT(widths.size(), 5u);
}

}  // namespace
}  // namespace holdfast
