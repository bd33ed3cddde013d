// No dialog comes over another one: what lies on top is asked of the display.

#include <QApplication>
#include <QDialog>
#include <functional>

#include <gtest/gtest.h>

#include "dialogs.h"
#include "files_window.h"
#include "gestures.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The window on the bracket, in a folder of its own.
class DialogsOverWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    const auto mesh = folder.file("part.obj", test::bytesOf(test::dataFolder() + "/bracket.obj"));
    window.files().open(QString::fromStdString(mesh.string()));
    ASSERT_TRUE(test::waitUntil([this] { return editor().isOpen() && !window.files().isOpening(); }));
    ASSERT_TRUE(settle());
  }

  void TearDown() override
  {
    if (editor().isOpen()) editor().markSaved(editor().history().state());
  }

  [[nodiscard]] QString fileOf(const char* name, const char* bytes) const
  {
    return QString::fromStdString(folder.file(name, bytes).string());
  }

  /// Does what ends with a box, and leaves the box by Escape once any progress dialog of the job would be there.
  void expectBoxStaysOnTop(const char* what, const std::function<void()>& act)
  {
    SCOPED_TRACE(what);
    bool isDone = false;
    const test::DialogAnswer answer("messageBox", [&](QDialog& box) {
      EXPECT_TRUE(test::isOnTop(box));
      test::passProgressDelay();
      EXPECT_EQ(test::findDialog("progress"), nullptr);
      EXPECT_TRUE(test::isOnTop(box));
      isDone = true;
      test::pressKey(box, Qt::Key_Escape);
    });
    act();
    ASSERT_TRUE(test::waitUntil([&] { return isDone && QApplication::activeModalWidget() == nullptr; }));
    ASSERT_TRUE(test::waitUntil([this] { return !window.files().isOpening() && !window.exports().isWriting(); }));
  }

  test::OwnSettings settings;
  test::TemporaryFolder folder;
};

TEST_F(DialogsOverWindow, MessagesStayOverTheProgressOfTheirOwnJob)
{
  const auto opening = [this](const char* name, const char* bytes) {
    return [this, path = fileOf(name, bytes)] { window.files().open(path); };
  };
  expectBoxStaysOnTop("text named .obj", opening("text.obj", "Dear Sir or Madam,\n"));
  expectBoxStaysOnTop("half an STL", opening("half.stl", "solid part\n facet normal 0 0\n"));
  expectBoxStaysOnTop("no session", opening("no.holdfast", "{\"format\": 1}"));
  expectBoxStaysOnTop("a session whose mesh is missing",
                      opening("lost.holdfast", R"({"format": "holdfast-constraints", "version": 1, "constraints": [],
                                                   "mesh": {"path": "lost.obj"}})"));
}

}  // namespace
}  // namespace holdfast
