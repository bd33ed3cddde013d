#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/window/files/import_dialog.h>

#include "dialogs.h"
#include "files_window.h"
#include "gestures.h"
#include "support/constraint_lists.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

using testing::ElementsAre;

constexpr const char* kHeader = "name,x,y,z,target_x,target_y,target_z\n";

class ImportDialogTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(w.open(w.sample("bracket.obj"))); }

  /// Opens the dialog, and waits for the table.
  void openDialog(const fs::path& path)
  {
    dialog.reset(newImportDialog(w.editor, path));
    dialog->open();
    ASSERT_TRUE(test::waitUntil([&] { return table().model()->rowCount() > 0; }));
  }

  [[nodiscard]] QTableView& table() const { return *dialog->findChild<QTableView*>("preview"); }
  [[nodiscard]] QVariant cell(int row, int column, int role = Qt::DisplayRole) const
  {
    return table().model()->index(row, column).data(role);
  }
  [[nodiscard]] bool isTicked(int row) const { return cell(row, 0, Qt::CheckStateRole).toInt() == Qt::Checked; }
  [[nodiscard]] QString importText() const { return dialog->findChild<QPushButton*>("import")->text().remove('&'); }
  /// The place of vertex 0 and one that is far away.
  [[nodiscard]] fs::path nearAndFar() const
  {
    const Vector3 p = w.editor.model()->mesh.positions.row(0);
    const std::string near = std::to_string(p.x()) + ',' + std::to_string(p.y()) + ',' + std::to_string(p.z());
    return w.folder.file("measured.csv", std::string(kHeader) + "A," + near + ",1,2,3\nB,1e4,0,0,4,5,0.1\n");
  }
  [[nodiscard]] std::vector<std::string> names() const
  {
    std::vector<std::string> all;
    for (const Constraint& constraint : w.editor.list().constraints) all.push_back(constraint.name);
    return all;
  }

  test::FilesWindow w;
  std::unique_ptr<QDialog> dialog;
};

TEST_F(ImportDialogTest, AnImportIsOneEditThatHoldsTheFileExactly)
{
  const fs::path path = w.sample("bracket.measured.csv");
  openDialog(path);
  const ConstraintList expected = readConstraints(path);
  EXPECT_EQ(table().model()->rowCount(), static_cast<int>(expected.constraints.size()));
  EXPECT_EQ(importText(), QString("Import %1").arg(expected.constraints.size()));
  test::clickButton(*dialog, "import");
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_TRUE(test::areSame(w.editor.list(), expected));
  EXPECT_EQ(w.editor.history().undoName(),
            "import " + std::to_string(expected.constraints.size()) + " points from bracket.measured.csv");
  w.editor.undo();
  EXPECT_TRUE(w.editor.list().constraints.empty());
  EXPECT_FALSE(w.editor.history().canUndo());
}

TEST_F(ImportDialogTest, PointsFarFromTheSurfaceAreLeftOutUnlessTicked)
{
  openDialog(nearAndFar());
  EXPECT_TRUE(isTicked(0));
  EXPECT_FALSE(isTicked(1));
  EXPECT_FALSE(cell(0, 4, Qt::ForegroundRole).isValid());
  EXPECT_TRUE(cell(1, 4, Qt::ForegroundRole).isValid()) << "it stands out";
  EXPECT_EQ(importText(), "Import 1");
  // The box in front of the name, as a user ticks it.
  table().setCurrentIndex(table().model()->index(1, 0));
  test::pressKey(table(), Qt::Key_Space);
  EXPECT_TRUE(isTicked(1));
  test::clickButton(*dialog, "import");
  EXPECT_THAT(names(), ElementsAre("A", "B"));
}

TEST_F(ImportDialogTest, TheToleranceIsTypedAndImportsNothingByItself)
{
  openDialog(nearAndFar());
  auto* tolerance = dialog->findChild<QLineEdit*>("tolerance");
  tolerance->setFocus();
  tolerance->clear();
  test::type(*tolerance, "1e6");
  test::pressKey(*tolerance, Qt::Key_Return);
  EXPECT_TRUE(isTicked(1));
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_TRUE(w.editor.list().constraints.empty());
  test::clickButton(*dialog, "tickNone");
  EXPECT_FALSE(dialog->findChild<QPushButton*>("import")->isEnabled());
  test::clickButton(*dialog, "tickAll");
  EXPECT_EQ(importText(), "Import 2");
}

TEST_F(ImportDialogTest, EnterInTheTableImportsWhatIsTicked)
{
  openDialog(nearAndFar());
  EXPECT_EQ(dialog->focusWidget(), &table());
  test::pressKey(table(), Qt::Key_Return);
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_THAT(names(), ElementsAre("A"));
}

TEST_F(ImportDialogTest, NamesThatAreTakenAreShownAsWhatTheyBecome)
{
  w.editor.edit("hold", added(w.editor.list(), {"A", true, PointConstraint{AtVertex{3}, Move{}}}));
  openDialog(nearAndFar());
  EXPECT_EQ(cell(0, 0).toString(), "A → A 2");
  EXPECT_EQ(cell(1, 0).toString(), "B");
  test::clickButton(*dialog, "import");
  EXPECT_THAT(names(), ElementsAre("A", "A 2"));
}

TEST_F(ImportDialogTest, ConstraintsOfAllKindsAreTakenIn)
{
  const fs::path path = w.sample("bracket.constraints.json");
  openDialog(path);
  test::clickButton(*dialog, "import");
  EXPECT_TRUE(test::areSame(w.editor.list(), readConstraints(path)));
  EXPECT_EQ(w.editor.list().units, readConstraints(path).units);
}

TEST_F(ImportDialogTest, ACancelledImportChangesNothing)
{
  openDialog(nearAndFar());
  const auto state = w.editor.history().state();
  test::pressKey(*dialog, Qt::Key_Escape);
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_EQ(w.editor.history().state(), state);
}

TEST_F(ImportDialogTest, RowsWithFaultsStandMarkedAndTheRestIsTaken)
{
  const Vector3 p = w.editor.model()->mesh.positions.row(0);
  const std::string at = std::to_string(p.x()) + ',' + std::to_string(p.y()) + ',' + std::to_string(p.z());
  openDialog(w.folder.file("faults.csv", std::string(kHeader) + "A," + at + ",1,2,3\nB,0,0,zero,1,2,3\nA," + at +
                                             ",4,5,6\nC,1e4,0,0,1,2,3\nD," + at + ",7,8,9\n"));
  ASSERT_EQ(table().model()->rowCount(), 5);
  EXPECT_EQ(cell(1, 5).toString(), "Line 3: column z: \"zero\" is not a number; correct it.");
  EXPECT_TRUE(cell(2, 5).toString().startsWith("Line 4: column name: \"A\" is the name of the point in line 2"));
  for (const int row : {1, 2, 3}) {
    EXPECT_TRUE(cell(row, 0, Qt::ForegroundRole).isValid()) << row;
    EXPECT_FALSE(isTicked(row)) << row;
  }
  EXPECT_EQ(importText(), "Import 2");
  test::clickButton(*dialog, "tickAll");
  EXPECT_FALSE(isTicked(1)) << "it cannot be read";
  EXPECT_EQ(importText(), "Import 4");
  test::clickButton(*dialog, "import");
  EXPECT_THAT(names(), ElementsAre("A", "A 2", "C", "D"));
}

TEST_F(ImportDialogTest, DecimalCommasSemicolonsAndOtherColumnsAreFound)
{
  openDialog(w.folder.file("scan.csv", "Nr;X;Y;Z\nA;1,5;0;0\nB;2;0,25;0\n"));
  EXPECT_EQ(cell(0, 0).toString(), "point 1");
  EXPECT_EQ(cell(0, 2).toString(), "(1.5, 0, 0)");
  EXPECT_EQ(cell(1, 3).toString(), "(2, 0.25, 0)") << "without targets they go where they were measured";
  const auto choose = [this](const char* name, int entry) {
    auto* box = dialog->findChild<QComboBox*>(name);
    ASSERT_TRUE(box->isVisible());
    box->setFocus();
    const int before = box->currentIndex();
    for (int k = before; k < entry; ++k) test::pressKey(*box, Qt::Key_Down);
    for (int k = before; k > entry; --k) test::pressKey(*box, Qt::Key_Up);
    ASSERT_EQ(box->currentIndex(), entry);
  };
  choose("column0", 1);
  ASSERT_TRUE(test::waitUntil([&] { return cell(0, 0).toString() == "A"; }));
  choose("unit", 2);
  ASSERT_TRUE(test::waitUntil([&] { return cell(0, 2).toString() == "(15, 0, 0)"; }));
  choose("decimalSign", 0);
  ASSERT_TRUE(test::waitUntil(
      [&] { return cell(0, 5).toString().contains("\"1,5\" is not a number; the decimal sign is a point"); }));
}

TEST_F(ImportDialogTest, AFileThatIsNoTableIsRefusedWithItsLine)
{
  dialog.reset(newImportDialog(w.editor, w.folder.file("bad.csv", std::string(kHeader) + "A,0,0,0,1,2,3\n\"B,0\n")));
  dialog->open();
  QString said;
  const test::DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  ASSERT_TRUE(test::waitUntil([&] { return !dialog->isVisible(); }));
  EXPECT_TRUE(said.contains("Line: 3")) << said.toStdString();
}

TEST_F(ImportDialogTest, AHundredThousandPointsAreLookedAtWhileTheWindowGoesOn)
{
  std::string csv = kHeader;
  constexpr int kPoints = 100'000;
  for (int k = 0; k < kPoints; ++k) csv += ',' + std::to_string(k * 1e-4) + ",0.5,0.25,1,2,3\n";
  dialog.reset(newImportDialog(w.editor, w.folder.file("many.csv", csv)));
  dialog->open();
  EXPECT_EQ(table().model()->rowCount(), 0) << "nothing was done in the window's time";
  ASSERT_TRUE(test::waitUntil([&] { return table().model()->rowCount() == kPoints; }));
}

TEST_F(ImportDialogTest, IsAskedForAFileFirst)
{
  w.answers = {w.sample("bracket.measured.csv")};
  w.files.importDialog();
  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("importDialog") != nullptr; }));
  test::pressKey(*test::findDialog("importDialog"), Qt::Key_Escape);
  EXPECT_TRUE(test::waitUntil([] { return test::findDialog("importDialog") == nullptr; }));
}

}  // namespace
}  // namespace holdfast
