// Rows: their selection, order and filter, and how they come and go.

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QMimeData>

#include <holdfast/window/model/constraint_actions.h>

#include "sheet_panel.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;
using test::ConstraintPanelOfSheet;

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

TEST_F(ConstraintPanelOfSheet, TenThousandRowsAreShownFilteredAndSortedFluently)
{
  ConstraintList many = test::sheetList();
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
