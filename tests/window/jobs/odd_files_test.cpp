// Job 7: files that are damaged, missing or peculiar.

#include <QDialog>
#include <QMessageBox>
#include <QPushButton>

#include <gtest/gtest.h>

#include <holdfast/window/controls/panel_parts.h>

#include "support/source_tree.h"
#include "window/dialogs.h"
#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

class OddFilesJob : public test::JobWindow {
 protected:
  /// What the box says that comes of Ctrl+O and the file.
  [[nodiscard]] std::string refusalOf(const std::filesystem::path& file, const char* button = "OK")
  {
    QString said;
    const test::DialogAnswer answer("messageBox", [&](QDialog& box) {
      said = test::textOf(box);
      test::clickButton(box, button);
    });
    chooseFile(file.string());
    waitForKeys();
    key(Qt::Key_O, Qt::ControlModifier);
    EXPECT_TRUE(test::waitUntil([&] { return answer.isGiven() && !window.files().isOpening(); }));
    return said.toStdString();
  }

  /// Ctrl+I, the file, and all that it has.
  void import(const std::filesystem::path& file)
  {
    chooseFile(file.string());
    key(Qt::Key_I, Qt::ControlModifier);
    ASSERT_TRUE(test::waitUntil([] { return test::findDialog("importDialog") != nullptr; }));
    QDialog& dialog = *test::findDialog("importDialog");
    auto& button = *dialog.findChild<QPushButton*>("import");
    ASSERT_TRUE(test::waitUntil([&] { return button.isEnabled(); }));
    test::clickButton(dialog, "import");
    ASSERT_FALSE(list().constraints.empty());
    ASSERT_TRUE(settle());
  }

  void expectRefused(const char* name, const std::string& bytes, const std::vector<const char*>& words)
  {
    const auto state = editor().history().state();
    const std::string said = refusalOf(folder.file(name, bytes));
    for (const char* word : words) EXPECT_NE(said.find(word), std::string::npos) << word << " in: " << said;
    EXPECT_NE(said.find(name), std::string::npos) << said;
    EXPECT_EQ(editor().history().state(), state) << "the open document stays";
  }
};

TEST_F(OddFilesJob, SayWhatIsWrongAndLeaveTheDocument)
{
  openFile(sample("bracket.obj"));
  holdVertex(freeVertex());
  chooseFile(path("mine.holdfast").string());
  key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([this] { return !window.files().isSaving(); }));
  const std::string head = test::bytesOf(test::dataFolder() + "/head.ply");
  expectRefused("cut short.ply", head.substr(0, head.size() / 2), {"truncated", "byte"});
  expectRefused("corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n", {"Line: 4", "7"});
  expectRefused("letters.off", "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", {"Line: 4", "zero"});
  expectRefused("empty.stl", "", {"empty"});
  expectRefused("no mesh.obj", "# nothing\n", {"no vertices"});
  expectRefused("newer.holdfast", R"({"format": "holdfast-constraints", "version": 3, "constraints": []})",
                {"Version 3", "newer"});
  expectRefused("old key.holdfast",
                R"({"format": "holdfast-constraints", "version": 1, "constraints": [], "mesh": {"path": "a.obj"},
                    "selection": []})",
                {"selection", "did you mean"});
  EXPECT_NE(refusalOf(path("gone.obj")).find("File not found"), std::string::npos);

  // The mesh of a session has moved: it is asked for, and found.
  const auto session = sample("bracket.holdfast");
  std::filesystem::rename(path("bracket.obj"), path("moved.obj"));
  const test::DialogAnswer missing("messageBox", [this](QDialog& box) {
    chooseFile(path("moved.obj").string());
    test::clickButton(box, "locate");
  });
  openFile(session);
  EXPECT_EQ(editor().mesh().path.filename(), "moved.obj");
  EXPECT_EQ(list().constraints.size(), 22u);
  EXPECT_TRUE(window.isWindowModified()) << "the session has another path";
  expectAllMet();
  expectPicture();
}

TEST_F(OddFilesJob, CornersThatShareAPlaceMoveAsOne)
{
  openFile(sample("cube_unwelded.stl"));
  import(sample("cube_unwelded.constraints.json"));
  openPanel("Mesh");
  EXPECT_TRUE(find<Card>("finding0").isVisible());
  Index pairs = 0;
  for (Index v = 0; v < editor().model()->mesh.vertexCount(); ++v)
    for (Index w = 0; w < v; ++w) {
      if (restOf(v) != restOf(w)) continue;
      ++pairs;
      ASSERT_EQ(nowOf(v), nowOf(w)) << v << ", " << w;
    }
  EXPECT_GT(pairs, 50);
  EXPECT_NE(editor().positions(), editor().model()->mesh.positions);
  expectAllMet();
  expectPicture();
}

TEST_F(OddFilesJob, APartWithoutConstraintsStaysAndIsTold)
{
  openFile(sample("two_parts.obj"));
  import(sample("two_parts.constraints.json"));
  openPanel("Mesh");
  EXPECT_TRUE(find<Card>("finding0").isVisible());
  Index moved = 0;
  for (Index v = 0; v < editor().model()->mesh.vertexCount(); ++v) {
    if (nowOf(v) != restOf(v)) ++moved;
    if (restOf(v).x() > 10) {
      EXPECT_EQ(nowOf(v), restOf(v)) << v;
    }
  }
  EXPECT_GT(moved, 20);
  expectAllMet();
  expectPicture();
}

}  // namespace
}  // namespace holdfast
