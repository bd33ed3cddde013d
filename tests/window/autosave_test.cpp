#include <QCoreApplication>
#include <QDialog>
#include <chrono>
#include <csignal>
#include <string>

#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>

#include "dialogs.h"
#include "gestures.h"
#include "kept_window.h"
#include "support/child_process.h"
#include "support/constraint_lists.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

class AutosaveTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<fs::path> copies() const { return test::copiesIn(recovery); }

  test::TemporaryFolder state;
  fs::path recovery = state.path() / "recovery";
};

TEST_F(AutosaveTest, UnsavedWorkIsKeptBitForBit)
{
  test::KeptWindow w(recovery);
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  EXPECT_TRUE(copies().empty()) << "nothing was done yet";
  w.editor.edit("import", readConstraints(test::dataFolder() + "/bracket.constraints.json"));
  ASSERT_TRUE(w.waitForCopy(1));
  ASSERT_EQ(copies().size(), 1U);
  EXPECT_TRUE(test::areSame(readSession(copies()[0]).document.list, w.editor.list()));
}

TEST_F(AutosaveTest, TheCopyFollowsTheWork)
{
  test::KeptWindow w(recovery);
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  for (int k = 1; k <= 3; ++k) {
    w.holdVertex(k);
    ASSERT_TRUE(w.waitForCopy(k));
    ASSERT_EQ(copies().size(), 1U);
    EXPECT_EQ(readSession(copies()[0]).document.list.constraints.size(), static_cast<std::size_t>(k));
  }
}

TEST_F(AutosaveTest, WorkWithoutAPauseIsKeptToo)
{
  test::KeptWindow w(recovery);
  w.autosave->setDelay(std::chrono::seconds(1));
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  int works = 0;
  EXPECT_TRUE(test::waitUntil([&] {
    ConstraintList next = w.editor.list();
    next.units = std::to_string(++works);
    w.editor.edit("work", next);
    return w.kept > 0;
  }));
}

TEST_F(AutosaveTest, TheCopyGoesWhenTheWorkIsSaved)
{
  test::KeptWindow w(recovery);
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  w.holdVertex(3);
  ASSERT_TRUE(w.waitForCopy(1));
  w.answers = {w.path("part.holdfast")};
  ASSERT_TRUE(w.files.save());
  EXPECT_TRUE(copies().empty());
}

TEST_F(AutosaveTest, TheCopyGoesWhenTheWindowIsClosedAsItShouldBe)
{
  test::KeptWindow w(recovery);
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  w.holdVertex(3);
  ASSERT_TRUE(w.waitForCopy(1));
  w.autosave.reset();
  EXPECT_TRUE(copies().empty());
}

TEST_F(AutosaveTest, TheCopyGoesWithItsDocument)
{
  test::KeptWindow w(recovery);
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  w.holdVertex(3);
  ASSERT_TRUE(w.waitForCopy(1));
  w.editor.close();
  EXPECT_TRUE(copies().empty());
}

TEST_F(AutosaveTest, ACopyThatIsBeingWrittenGoesWithItsDocument)
{
  test::KeptWindow w(recovery);
  w.autosave->setDelay(std::chrono::seconds(0));
  const fs::path part = w.sample("bracket.obj");
  for (int k = 0; k < 5; ++k) {
    ASSERT_TRUE(w.open(part));
    w.holdVertex(3);
    QCoreApplication::processEvents();  // a copy is begun
    w.editor.close();
    EXPECT_TRUE(test::waitUntil([&] { return copies().empty(); }));
  }
}

TEST_F(AutosaveTest, NothingIsWrittenInTheMiddleOfAGesture)
{
  test::KeptWindow w(recovery);
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  w.editor.beginGesture("drag");
  w.editor.updateGesture(added(w.editor.list(), {"P1", true, PointConstraint{AtVertex{3}, Move{}}}));
  ASSERT_TRUE(w.waitForCurrent());
  EXPECT_EQ(w.kept, 0);
  EXPECT_TRUE(copies().empty());
  w.editor.endGesture();
  EXPECT_TRUE(w.waitForCopy(1));
}

TEST_F(AutosaveTest, AFolderThatCannotBeMadeIsToldOnce)
{
  static_cast<void>(state.file("recovery", "in the way"));
  test::KeptWindow w(recovery);
  QStringList reasons;
  QObject::connect(w.autosave.get(), &Autosave::failed, &w.window, [&](const QString& reason) { reasons << reason; });
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  w.holdVertex(3);
  ASSERT_TRUE(test::waitUntil([&] { return !reasons.isEmpty(); }));
  EXPECT_TRUE(reasons[0].contains("recovery")) << reasons[0].toStdString();
  w.holdVertex(4);
  ASSERT_TRUE(w.waitForCurrent());
  EXPECT_EQ(reasons.size(), 1);
}

// Of another program that is killed

class CrashedWindow : public ::testing::Test {
 protected:
  CrashedWindow() { static_cast<void>(home.file("bracket.obj", test::bytesOf(test::dataFolder() + "/bracket.obj"))); }

  /// Lets a window work and kills it (SIGKILL): nothing is tidied up.
  void crash()
  {
    test::ProcessOptions options;
    options.signal = SIGKILL;
    options.signalAt = test::kWorkIsKept;
    options.timeout = std::chrono::seconds(60);
    const test::ProcessResult result = test::runProcess(
        {fs::read_symlink("/proc/self/exe").string(), test::kWorkUntilKilled, home.path().string()}, options);
    ASSERT_EQ(result.signal, SIGKILL) << result.err << result.out;
    ASSERT_EQ(recoverable(recovery).size(), 1U);
  }

  /// Answers the offer at the start of a window, and waits for the work to be open.
  static void recoverIn(test::KeptWindow& w)
  {
    ASSERT_TRUE(test::showAndWait(w.window));
    w.autosave->offerRecovery();
    const test::DialogAnswer answer("recoveryDialog", [](QDialog& dialog) { test::clickButton(dialog, "recover"); });
    ASSERT_TRUE(test::waitUntil([&] { return w.editor.isOpen(); }));
    ASSERT_TRUE(w.waitForCopy(1));
  }

  test::TemporaryFolder home;
  fs::path recovery = home.path() / "recovery";
};

TEST_F(CrashedWindow, LeavesItsWorkBitForBit)
{
  crash();
  test::KeptWindow w(recovery);
  recoverIn(w);
  EXPECT_TRUE(test::areSame(w.editor.list(), test::workOf({})));
  EXPECT_EQ(w.editor.state().options.weights, Weights::Uniform);
  EXPECT_FALSE(w.editor.history().isSaved());
  EXPECT_TRUE(w.files.sessionPath().empty());
  EXPECT_EQ(w.editor.mesh().path, home.path() / "bracket.obj");
  EXPECT_TRUE(recoverable(recovery).empty()) << "this window keeps the work now";
  EXPECT_EQ(test::copiesIn(recovery).size(), 1U);
}

TEST_F(CrashedWindow, LeavesWorkThatIsSavedWhereItCameFrom)
{
  {
    test::FilesWindow w;
    ASSERT_TRUE(w.open(home.path() / "bracket.obj"));
    w.holdVertex(3);
    w.answers = {home.path() / "part.holdfast"};
    ASSERT_TRUE(w.files.save());
  }
  const std::string before = test::bytesOf(home.path() / "part.holdfast");
  crash();
  test::KeptWindow w(recovery);
  recoverIn(w);
  EXPECT_EQ(test::bytesOf(home.path() / "part.holdfast"), before) << "until the user saves";
  EXPECT_EQ(w.files.sessionPath(), home.path() / "part.holdfast");
  ASSERT_TRUE(w.files.save());
  EXPECT_TRUE(test::areSame(readSession(home.path() / "part.holdfast").document.list, w.editor.list()));
  EXPECT_EQ(w.editor.list().constraints.size(), 3U);
  EXPECT_TRUE(test::copiesIn(recovery).empty());
}

TEST_F(CrashedWindow, LeavesWorkThatCanWaitOrBeDiscarded)
{
  crash();
  test::KeptWindow w(recovery);
  ASSERT_TRUE(test::showAndWait(w.window));
  w.autosave->offerRecovery();
  {
    const test::DialogAnswer answer("recoveryDialog", [](QDialog& dialog) { test::clickButton(dialog, "later"); });
    ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  }
  EXPECT_EQ(recoverable(recovery).size(), 1U);

  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("recoveryDialog") == nullptr; }));
  w.autosave->offerRecovery();
  const test::DialogAnswer confirm("messageBox", [](QDialog& box) { test::clickButton(box, "goOn"); });
  const test::DialogAnswer answer("recoveryDialog", [](QDialog& dialog) { test::clickButton(dialog, "discard"); });
  ASSERT_TRUE(test::waitUntil([&] { return confirm.isGiven(); }));
  EXPECT_TRUE(test::waitUntil([&] { return recoverable(recovery).empty(); }));
  EXPECT_FALSE(w.editor.isOpen());
}

}  // namespace
}  // namespace holdfast
