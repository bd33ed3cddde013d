// Job 8: all of it without a mouse.

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QTreeWidget>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <holdfast/window/table/constraint_table_model.h>

#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;

class KeyboardJob : public test::JobWindow {
 protected:
  [[nodiscard]] Vector3 targetOf(Index constraint)
  {
    return std::get<Target>(std::get<PointConstraint>(list().constraints[constraint].what).to).place;
  }

  /// Two points, measured elsewhere and copied there.
  void pastePoints()
  {
    ASSERT_TRUE(tabTo(table()));
    QApplication::clipboard()->setText(
        "name,x,y,z,target_x,target_y,target_z\n"
        "base,-49,-19,0,-49,-19,0\n"
        "crown,0,23,70,0,23,71\n");
    key(Qt::Key_V, Qt::ControlModifier);
    ASSERT_EQ(list().constraints.size(), 2u);
    ASSERT_TRUE(settle());
  }

  void saveAs(const std::filesystem::path& file)
  {
    chooseFile(file.string());
    key(Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(test::waitUntil([this] { return !window.files().isSaving(); }));
    ASSERT_FALSE(window.isWindowModified());
  }
};

TEST_F(KeyboardJob, HoldsMovesNamesUndoesAndSaves)
{
  openFile(sample("bracket.obj"));
  pastePoints();
  key(Qt::Key_Home, Qt::ControlModifier);
  key(Qt::Key_Down);
  EXPECT_EQ(editor().selectedConstraints(), (std::vector<Index>{1}));
  goToColumn(Table::Z);
  typeIntoCell("72.125");
  EXPECT_EQ(targetOf(1), Vector3(0, 23, 72.125));
  EXPECT_EQ(shown(1, Table::Status), "met");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(targetOf(1), Vector3(0, 23, 71));
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(targetOf(1), Vector3(0, 23, 72.125));

  // The whole mesh under a name, typed at once, and selected again.
  viewport().setFocus();
  key(Qt::Key_I);
  const std::vector<Index> all = editor().selectedVertices();
  key(Qt::Key_G, Qt::ControlModifier);
  auto& tree = find<QTreeWidget>("selectionTree");
  ASSERT_TRUE(test::waitUntil([&] { return qobject_cast<QLineEdit*>(QApplication::focusWidget()) != nullptr; }));
  key(Qt::Key_A, Qt::ControlModifier);
  keys("everything");
  key(Qt::Key_Return);
  ASSERT_TRUE(test::waitUntil([&] { return QApplication::focusWidget() == &tree; }));
  EXPECT_EQ(editor().annotations().selections[0].name, "everything");
  key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(editor().selectedVertices().empty());
  key(Qt::Key_Return);
  EXPECT_EQ(editor().selectedVertices(), all);

  saveAs(path("keys.holdfast"));
  const auto written = nlohmann::json::parse(test::bytesOf(path("keys.holdfast")));
  EXPECT_EQ(written.at("constraints").at(1).at("target").at(2).get<double>(), 72.125);
  EXPECT_EQ(written.at("selections").at(0).at("name"), "everything");
  expectAllMet();
  expectPicture();
}

}  // namespace
}  // namespace holdfast
