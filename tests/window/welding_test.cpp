// A mesh with a seam that was never closed: the user welds it, edits on, and takes it back.

#include <QLabel>
#include <QLineEdit>
#include <fstream>

#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>

#include "dialogs.h"
#include "support/temporary_folder.h"
#include "window_user.h"

namespace holdfast {
namespace {

constexpr double kGap = 1e-9;

class Welding : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    const std::filesystem::path path = folder.path() / "seam.off";
    std::ofstream(path) << "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1.000000001 0 0\n2 0 0\n2 1 0\n1.000000001 1 0\n"
                           "4 0 1 2 3\n4 4 5 6 7\n";
    window.files().open(QString::fromStdString(path.string()));
    ASSERT_TRUE(test::waitUntil([this] { return !window.files().isOpening() && editor().isOpen(); }));
    openPanel("Solution");
    holdVertexAt(0, Vector3::Zero());
    holdVertexAt(2, Vector3(0, 0, 1));
  }

  void holdVertexAt(Index vertex, const Vector3& move)
  {
    const std::string name = "v" + std::to_string(vertex);
    editor().edit("hold", added(editor().list(), {name, true, PointConstraint{AtVertex{vertex}, Move{move}}}));
    ASSERT_TRUE(settle());
  }

  void typeWeld(const char* tolerance)
  {
    clickOn(weld());
    weld().selectAll();
    test::type(weld(), tolerance);
    test::pressKey(weld(), Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([this] { return !window.files().isOpening(); }));
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] QLineEdit& weld() { return find<QLineEdit>("reportWeld"); }
  [[nodiscard]] double openBy() { return (editor().positions().row(2) - editor().positions().row(7)).norm(); }

  test::TemporaryFolder folder;
};

TEST_F(Welding, ClosesASeamAndUndoOpensIt)
{
  EXPECT_EQ(weld().text(), "0");
  EXPECT_NEAR(openBy(), 1, 1e-6);
  editor().selectConstraints({1});

  typeWeld("1e-8");
  EXPECT_LE(openBy(), 1.001 * kGap);
  EXPECT_EQ(editor().state().options.weldTolerance, 1e-8);
  EXPECT_EQ(editor().history().undoName(), "weld within 1e-08");
  EXPECT_EQ(editor().selectedConstraints(), std::vector<Index>{1});
  EXPECT_EQ(window.files().name(), "seam.off");

  editor().undo();
  ASSERT_TRUE(test::waitUntil([this] { return editor().hasItsMesh() && !window.files().isOpening(); }));
  ASSERT_TRUE(settle());
  EXPECT_NEAR(openBy(), 1, 1e-6);
  EXPECT_EQ(weld().text(), "0");
  editor().undo();
  EXPECT_EQ(editor().list().constraints.size(), 1U) << "edits before it can be undone as well";
  editor().redo();
  editor().redo();
  ASSERT_TRUE(test::waitUntil([this] { return editor().hasItsMesh() && !window.files().isOpening(); }));
  ASSERT_TRUE(settle());
  EXPECT_LE(openBy(), 1.001 * kGap);
}

TEST_F(Welding, OfTooMuchIsRefusedAndChangesNothing)
{
  const auto before = editor().history().state();
  QString said;
  const test::DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  clickOn(weld());
  weld().selectAll();
  test::type(weld(), "1");
  test::pressKey(weld(), Qt::Key_Return);
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  EXPECT_TRUE(said.contains("cannot be welded")) << qPrintable(said);
  EXPECT_EQ(editor().history().state(), before);
  EXPECT_TRUE(editor().isCurrent());
  EXPECT_EQ(weld().text(), "0");
}

TEST_F(Welding, OfLessThanNothingIsRefusedInPlace)
{
  typeWeld("-1");
  EXPECT_EQ(weld().text(), "0");
  EXPECT_TRUE(find<QLabel>("reportAge").text().contains("0 or more"));
}

}  // namespace
}  // namespace holdfast
