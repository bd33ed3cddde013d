// Job 3: a measured list with faults and a conflict.

#include <QDialog>
#include <QPushButton>
#include <QTableView>

#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/controls/panel_parts.h>

#include "window/dialogs.h"
#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

constexpr const char* kMeasured =
    "name,x,y,z,target_x,target_y,target_z\n"
    "datum 1,-44.5,-19,0,-44.5,-19,0\n"
    "datum 2,53.5,-19,0,53.5,-19,0\n"
    "datum 3,-44.5,19,0,-44.5,19,0\n"
    "datum 3,53.5,19,0,53.5,19,0\n"   // a name twice
    "rim east,15,10,fifty,15,9,50\n"  // no number
    "lost,400,400,400,400,400,400\n"  // off the surface
    "rim west,-15,10,50,-15,9,50.5\n"
    "rim west again,-15,10,50,-15,9,52.5\n";  // another target for the same place

class FaultyListJob : public test::JobWindow {
 protected:
  void import(const std::filesystem::path& file)
  {
    chooseFile(file.string());
    key(Qt::Key_I, Qt::ControlModifier);
    ASSERT_TRUE(test::waitUntil([] { return test::findDialog("importDialog") != nullptr; }));
    QDialog& dialog = *test::findDialog("importDialog");
    auto& table = *dialog.findChild<QTableView*>("preview");
    ASSERT_TRUE(test::waitUntil([&] { return table.model()->rowCount() == 8; }));
    const auto isTicked = [&](int row) {
      return table.model()->index(row, 0).data(Qt::CheckStateRole).toInt() == Qt::Checked;
    };
    for (int row = 0; row < 8; ++row) EXPECT_EQ(isTicked(row), row < 3 || row > 5) << row;
    EXPECT_EQ(dialog.findChild<QPushButton*>("import")->text().remove('&'), "Import 5");
    test::clickButton(dialog, "import");
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] ConstraintStatus statusOf(const char* name)
  {
    return editor().deformation()->report.constraints[*indexOf(list(), name)].status;
  }
  [[nodiscard]] Vector3 targetOf(const char* name)
  {
    return std::get<Target>(std::get<PointConstraint>(list().constraints[*indexOf(list(), name)].what).to).place;
  }
};

TEST_F(FaultyListJob, WhatIsSoundIsTakenAndTheConflictRepaired)
{
  openFile(sample("bracket.obj"));
  import(folder.file("measured.csv", kMeasured));
  ASSERT_EQ(list().constraints.size(), 5u);
  EXPECT_EQ(statusOf("rim west"), ConstraintStatus::Met);
  EXPECT_EQ(statusOf("rim west again"), ConstraintStatus::Conflicting);
  EXPECT_EQ(tabOf("Conflicts"), "Conflicts (1)");

  openPanel("Conflicts");
  auto& prefer = *find<Card>("conflict0").findChild<QPushButton*>("conflictPrefer");
  ASSERT_TRUE(prefer.isVisible());
  clickOn(prefer);
  ASSERT_TRUE(settle());
  EXPECT_EQ(statusOf("rim west again"), ConstraintStatus::Met);
  EXPECT_EQ(statusOf("rim west"), ConstraintStatus::Conflicting);
  EXPECT_LT((nowOf(nearestVertex({-15, 9, 52.5})) - Vector3(-15, 9, 52.5)).norm(), 1e-9);

  clickOn(*find<Card>("conflict0").findChild<QPushButton*>("conflictAverage"));
  ASSERT_TRUE(settle());
  EXPECT_EQ(targetOf("rim west"), Vector3(-15, 9, 51.5));
  EXPECT_EQ(targetOf("rim west again"), Vector3(-15, 9, 51.5));
  EXPECT_EQ(tabOf("Conflicts"), "Conflicts");
  EXPECT_EQ(editor().deformation()->report.solve.status, SolveStatus::Ok);
  // Three edits, each of which can be undone: import, order, average.
  for (int k = 0; k < 3; ++k) key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(list().constraints.empty());
  for (int k = 0; k < 3; ++k) key(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(targetOf("rim west"), Vector3(-15, 9, 51.5));
  expectPicture();
}

}  // namespace
}  // namespace holdfast
