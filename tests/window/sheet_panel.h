#pragma once
/// \file
/// The panel of constraints on a flat sheet, and a user of its table.

#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/table/constraint_table.h>
#include <holdfast/window/table/constraint_table_model.h>

#include "gestures.h"
#include "open_document.h"
#include "support/meshes.h"

namespace holdfast::test {

/// A flat sheet of 10 x 10 squares, its left border fixed, with points of all kinds.
inline ConstraintList sheetList()
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
    ASSERT_TRUE(openMesh(editor, grid(10, 10), sheetList()));
    panel.resize(1100, 500);
    ASSERT_TRUE(showAndWait(panel));
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
    for (int row = 0; row < rows().rowCount(); ++row) result << shown(row, ConstraintTableModel::Name);
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
    click(*table().viewport(), middleOf(row, column), Qt::LeftButton, modifiers);
  }
  /// Types into a cell of the current row as a user does: F2, the text, Enter.
  void typeInto(int row, int column, const char* text)
  {
    table().selectionModel()->setCurrentIndex(rows().index(row, column), QItemSelectionModel::NoUpdate);
    pressKey(table(), Qt::Key_F2);
    QLineEdit* line = table().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr) << "the cell cannot be edited";
    line->selectAll();
    type(*line, text);
    pressKey(*line, Qt::Key_Return);
    ASSERT_TRUE(waitUntil([&] { return table().viewport()->findChild<QLineEdit*>() == nullptr; }));
  }
  [[nodiscard]] QLabel& refusal() { return *panel.findChild<QLabel*>("constraintRefusal"); }

  Editor editor;
  std::unique_ptr<QWidget> constraints{newConstraintPanel(editor, [](Index) {})};
  QWidget& panel = *constraints;
};

}  // namespace holdfast::test
