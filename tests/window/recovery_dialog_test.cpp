#include <QDialog>
#include <QListWidget>
#include <memory>

#include <gtest/gtest.h>

#include <holdfast/window/files/autosave.h>

namespace holdfast {
namespace {

TEST(RecoveryDialogTest, SaysOfEachCopyWhatItIsOf)
{
  const std::unique_ptr<QDialog> dialog(
      newRecoveryDialog({{"/kept/1.holdfast", "/parts/housing.holdfast", "/parts/housing.obj", {}, "housing"},
                         {"/kept/2.holdfast", "", "/scans/crown.ply", {}, "crown"},
                         {"/kept/3.holdfast", "", "", {}, "3"}},
                        [](const Recoverable&) {}));
  const auto& list = *dialog->findChild<QListWidget*>("copies");
  const auto lines = [&](int row) { return list.item(row)->text().split('\n'); };
  ASSERT_EQ(list.count(), 3);
  EXPECT_TRUE(lines(0).first().startsWith("housing, kept "));
  EXPECT_EQ(lines(0).last(), "/parts/housing.holdfast");
  EXPECT_EQ(lines(1).last(), "never saved; of the mesh /scans/crown.ply");
  EXPECT_EQ(lines(2).last(), "cannot be read: /kept/3.holdfast");
}

}  // namespace
}  // namespace holdfast
