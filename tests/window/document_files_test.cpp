#include <QDialog>
#include <QLineEdit>
#include <QMenu>

#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/window/files/document_files.h>
#include <holdfast/window/files/recent_files.h>

#include "dialogs.h"
#include "files_window.h"
#include "gestures.h"
#include "support/constraint_lists.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

using test::DialogAnswer;

class DocumentFilesTest : public ::testing::Test {
 protected:
  /// The bracket with its constraints, saved as part.holdfast, open and unchanged.
  void openSession()
  {
    ASSERT_TRUE(open(sample("bracket.obj")));
    w.editor.edit("import", readConstraints(test::dataFolder() + "/bracket.constraints.json"));
    w.answers = {w.path("part.holdfast")};
    ASSERT_TRUE(w.files.save());
    ASSERT_TRUE(w.waitForCurrent());
  }

  [[nodiscard]] bool open(const fs::path& path) { return w.open(path); }
  [[nodiscard]] fs::path sample(const std::string& name) const { return w.sample(name); }

  /// Opens `path`, answers the box that comes with `button`, and gives back what it said.
  QString openAndAnswer(const fs::path& path, const QString& button)
  {
    QString said;
    const DialogAnswer answer("messageBox", [&](QDialog& box) {
      said = test::textOf(box);
      test::clickButton(box, button);
    });
    w.files.open(QString::fromStdString(path.string()));
    EXPECT_TRUE(test::waitUntil([&] { return !w.files.isOpening() && answer.isGiven(); }));
    return said;
  }

  test::FilesWindow w;
};

TEST_F(DocumentFilesTest, TheWindowHandlesEventsWhileAMeshIsRead)
{
  w.files.open(QString::fromStdString(sample("bracket.obj").string()));
  EXPECT_TRUE(w.files.isOpening());
  EXPECT_FALSE(w.editor.isOpen()) << "nothing is done before the event loop goes on";
  ASSERT_TRUE(test::waitUntil([&] { return w.editor.isOpen(); }));
  EXPECT_EQ(w.files.name(), "bracket.obj");
  EXPECT_TRUE(w.files.sessionPath().empty());
  EXPECT_TRUE(w.window.windowFilePath().endsWith("/bracket.obj"));
  EXPECT_TRUE(w.editor.history().isSaved());
}

TEST_F(DocumentFilesTest, TheOpenDocumentStaysUntilTheNewOneIsReady)
{
  openSession();
  const auto state = w.editor.history().state();
  w.files.open(QString::fromStdString(sample("quads.obj").string()));
  EXPECT_EQ(w.editor.history().state(), state);
  ASSERT_TRUE(test::waitUntil([&] { return !w.files.isOpening(); }));
  EXPECT_EQ(w.files.name(), "quads.obj");
  EXPECT_TRUE(w.editor.list().constraints.empty());
}

TEST_F(DocumentFilesTest, ASavedSessionOpensAsTheSameDocument)
{
  openSession();
  const DocumentState saved = w.editor.state();
  const Positions positions = w.editor.positions();
  EXPECT_TRUE(w.editor.history().isSaved());
  EXPECT_TRUE(w.window.windowFilePath().endsWith("/part.holdfast"));

  test::FilesWindow other;
  ASSERT_TRUE(other.open(w.path("part.holdfast")));
  EXPECT_TRUE(test::areSame(other.editor.list(), saved.list));
  EXPECT_EQ(other.editor.state().options, saved.options);
  EXPECT_EQ(other.editor.positions(), positions);
  EXPECT_TRUE(other.editor.history().isSaved());
  EXPECT_EQ(other.files.sessionPath(), w.path("part.holdfast"));
}

TEST_F(DocumentFilesTest, TheViewIsKeptInTheSession)
{
  ViewState view;
  view.colorBy = "angle";
  view.camera = Camera{{1, 2, 3}, {0, 0, 0.1}, {0, 1, 0}, 7, true};
  w.files.setView([&] { return view; });
  openSession();
  test::FilesWindow other;
  ViewState opened;
  QObject::connect(&other.files, &DocumentFiles::viewOpened, &other.files,
                   [&](const ViewState& state) { opened = state; });
  ASSERT_TRUE(other.open(w.path("part.holdfast")));
  EXPECT_EQ(opened.colorBy, view.colorBy);
  EXPECT_EQ(opened.camera, view.camera);
}

TEST_F(DocumentFilesTest, SaveAsksForAPlaceOnceOnly)
{
  openSession();
  ASSERT_EQ(w.questions.size(), 1U);
  EXPECT_TRUE(w.questions[0].suggestion.endsWith("/bracket.holdfast")) << w.questions[0].suggestion.toStdString();
  w.holdVertex(3);
  EXPECT_FALSE(w.editor.history().isSaved());
  EXPECT_TRUE(w.files.save());
  EXPECT_TRUE(w.editor.history().isSaved());
  EXPECT_EQ(w.questions.size(), 1U);
  EXPECT_TRUE(test::areSame(readSession(w.path("part.holdfast")).document.list, w.editor.list()));
}

TEST_F(DocumentFilesTest, AFailureToSaveIsExplainedAndKeepsTheDocument)
{
  openSession();
  w.holdVertex(3);
  const auto state = w.editor.history().state();
  w.answers = {w.path("no such folder") / "part.holdfast"};
  QString said;
  const DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  w.files.saveAsInBackground();
  EXPECT_TRUE(w.files.isSaving());
  EXPECT_TRUE(test::waitUntil([&] { return !said.isEmpty(); }));
  EXPECT_TRUE(said.contains("no such folder")) << said.toStdString();
  EXPECT_EQ(w.editor.history().state(), state);
  EXPECT_FALSE(w.editor.history().isSaved());
  EXPECT_EQ(w.files.sessionPath(), w.path("part.holdfast"));
}

TEST_F(DocumentFilesTest, WhatIsEditedWhileItIsSavedIsUnsaved)
{
  openSession();
  w.holdVertex(3);
  const ConstraintList saved = w.editor.list();
  w.files.saveInBackground();
  w.holdVertex(4);
  ASSERT_TRUE(test::waitUntil([&] { return !w.files.isSaving(); }));
  EXPECT_FALSE(w.editor.history().isSaved());
  EXPECT_TRUE(test::areSame(readSession(w.path("part.holdfast")).document.list, saved));
  w.editor.undo();
  EXPECT_TRUE(w.editor.history().isSaved());
}

TEST_F(DocumentFilesTest, SavedOnceMoreWhileItIsSavedTheNewestStays)
{
  openSession();
  std::vector<QString> told;
  QObject::connect(&w.files, &DocumentFiles::done, &w.files, [&](const QString& what) { told.push_back(what); });
  for (const Index vertex : {3, 4, 5}) {
    w.holdVertex(vertex);
    w.files.saveInBackground();
  }
  ASSERT_TRUE(test::waitUntil([&] { return w.editor.history().isSaved(); }));
  EXPECT_FALSE(w.files.isSaving());
  EXPECT_EQ(told.size(), 2u) << "the one in between was older";
  EXPECT_TRUE(test::areSame(readSession(w.path("part.holdfast")).document.list, w.editor.list()));
}

TEST_F(DocumentFilesTest, NobodyIsAskedAboutWhatIsBeingSaved)
{
  openSession();
  w.holdVertex(3);
  w.files.saveInBackground();
  w.holdVertex(4);
  w.files.saveInBackground();
  EXPECT_TRUE(w.files.maySaveBefore("closing the window"));
  EXPECT_TRUE(w.editor.history().isSaved());
  EXPECT_TRUE(test::areSame(readSession(w.path("part.holdfast")).document.list, w.editor.list()));
}

TEST_F(DocumentFilesTest, ASaveGoesToItsFileThoughTheDocumentIsClosed)
{
  openSession();
  w.holdVertex(3);
  const ConstraintList saved = w.editor.list();
  w.files.saveInBackground();
  w.editor.close();
  ASSERT_TRUE(test::waitUntil([&] { return !w.files.isSaving(); }));
  EXPECT_TRUE(w.files.sessionPath().empty());
  EXPECT_TRUE(test::areSame(readSession(w.path("part.holdfast")).document.list, saved));
}

TEST_F(DocumentFilesTest, ASaveGoesToItsFileThoughTheWindowIsGone)
{
  auto other = std::make_unique<test::FilesWindow>();
  ASSERT_TRUE(other->open(other->sample("bracket.obj")));
  other->holdVertex(3);
  other->answers = {w.path("other.holdfast")};
  const ConstraintList saved = other->editor.list();
  other->files.saveAsInBackground();
  other.reset();
  EXPECT_TRUE(test::areSame(readSession(w.path("other.holdfast")).document.list, saved));
}

TEST_F(DocumentFilesTest, ACancelledSaveSavesNothing)
{
  ASSERT_TRUE(open(sample("bracket.obj")));
  w.holdVertex(3);
  EXPECT_FALSE(w.files.save());
  EXPECT_FALSE(w.editor.history().isSaved());
}

TEST_F(DocumentFilesTest, AMeshWithAMistakeIsRefusedWithItsLine)
{
  openSession();
  const auto state = w.editor.history().state();
  const fs::path bad = w.folder.file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 oops\nf 1 2 3\n");
  const QString said = openAndAnswer(bad, "OK");
  EXPECT_TRUE(said.contains("Line: 3")) << said.toStdString();
  EXPECT_TRUE(said.contains("bad.obj")) << said.toStdString();
  EXPECT_TRUE(said.contains("oops")) << said.toStdString();
  EXPECT_EQ(w.editor.history().state(), state);
}

TEST_F(DocumentFilesTest, ASessionWithAMistakeIsRefusedWithItsPlace)
{
  const fs::path bad = w.folder.file("bad.holdfast", R"({"format": "holdfast-constraints", "version": 1,
    "constraints": [{"type": "point", "at": {"vertex": -3}, "move": [0, 0, 0]}], "mesh": {"path": "x.obj"}})");
  const QString said = openAndAnswer(bad, "OK");
  EXPECT_TRUE(said.contains("Place: constraints[0].at.vertex")) << said.toStdString();
}

TEST_F(DocumentFilesTest, UnsavedChangesAreOnlyLostWithLeave)
{
  openSession();
  w.holdVertex(3);
  const auto state = w.editor.history().state();
  const auto answerWith = [&](const char* button) {
    const DialogAnswer answer("messageBox", [&](QDialog& box) {
      EXPECT_TRUE(test::textOf(box).contains("part.holdfast")) << test::textOf(box).toStdString();
      test::clickButton(box, button);
    });
    return w.files.maySaveBefore("closing the window");
  };
  EXPECT_FALSE(answerWith("Cancel"));
  EXPECT_FALSE(w.editor.history().isSaved());
  EXPECT_TRUE(answerWith("Discard"));
  EXPECT_EQ(readSession(w.path("part.holdfast")).document.list.constraints.size(), state->list.constraints.size() - 1);
  EXPECT_TRUE(answerWith("Save"));
  EXPECT_TRUE(test::areSame(readSession(w.path("part.holdfast")).document.list, state->list));
  EXPECT_TRUE(w.files.maySaveBefore("closing the window")) << "without a question";
}

TEST_F(DocumentFilesTest, OpeningAsksAboutUnsavedChangesFirst)
{
  openSession();
  w.holdVertex(3);
  const auto state = w.editor.history().state();
  openAndAnswer(sample("quads.obj"), "Cancel");
  EXPECT_EQ(w.editor.history().state(), state);
  openAndAnswer(sample("quads.obj"), "Discard");
  EXPECT_EQ(w.files.name(), "quads.obj");
}

TEST_F(DocumentFilesTest, ChangesMadeWhileAFileIsReadAreAskedAboutToo)
{
  openSession();
  w.files.open(QString::fromStdString(sample("quads.obj").string()));
  w.holdVertex(3);
  const DialogAnswer answer("messageBox", [](QDialog& box) { test::clickButton(box, "Cancel"); });
  ASSERT_TRUE(test::waitUntil([&] { return !w.files.isOpening() && answer.isGiven(); }));
  EXPECT_EQ(w.files.name(), "part.holdfast");
  EXPECT_FALSE(w.editor.history().isSaved());
}

TEST_F(DocumentFilesTest, AMissingMeshCanBeLocated)
{
  openSession();
  fs::rename(w.path("bracket.obj"), w.path("moved.obj"));
  test::FilesWindow other;
  other.answers = {w.path("moved.obj")};
  const DialogAnswer answer("messageBox", [](QDialog& box) { test::clickButton(box, "locate"); });
  ASSERT_TRUE(other.open(w.path("part.holdfast")));
  EXPECT_EQ(other.editor.mesh().path, w.path("moved.obj"));
  EXPECT_TRUE(test::areSame(other.editor.list(), w.editor.list()));
  EXPECT_FALSE(other.editor.history().isSaved()) << "the session names another mesh now";
  ASSERT_TRUE(other.files.save());
  EXPECT_EQ(readSession(w.path("part.holdfast")).mesh.path, "moved.obj");
}

TEST_F(DocumentFilesTest, AChangedMeshIsOnlyUsedWithLeave)
{
  openSession();
  static_cast<void>(w.folder.file("bracket.obj", test::bytesOf(w.path("bracket.obj")) + "# another\n"));
  test::FilesWindow other;
  {
    const DialogAnswer answer("messageBox", [](QDialog& box) {
      EXPECT_TRUE(test::textOf(box).contains("checksum")) << test::textOf(box).toStdString();
      test::clickButton(box, "Cancel");
    });
    EXPECT_FALSE(other.open(w.path("part.holdfast")));
  }
  const DialogAnswer answer("messageBox", [](QDialog& box) { test::clickButton(box, "useAllTheSame"); });
  ASSERT_TRUE(other.open(w.path("part.holdfast")));
  EXPECT_FALSE(other.editor.history().isSaved());
}

TEST_F(DocumentFilesTest, SavingNeedsNoMeshOnTheDisk)
{
  openSession();
  const std::string checksum = readSession(w.path("part.holdfast")).mesh.checksum;
  fs::remove(w.path("bracket.obj"));
  w.holdVertex(3);
  EXPECT_TRUE(w.files.save());
  EXPECT_EQ(readSession(w.path("part.holdfast")).mesh.checksum, checksum);
}

TEST_F(DocumentFilesTest, RecentFilesAreTheLatestTenThatWereOpen)
{
  openSession();
  const QStringList expected{QString::fromStdString(w.path("part.holdfast").string()),
                             QString::fromStdString(w.path("bracket.obj").string())};
  EXPECT_EQ(recentFiles(), expected);
  for (int k = 0; k < 12; ++k) addRecentFile(QString("/somewhere/%1.obj").arg(k));
  EXPECT_EQ(recentFiles().size(), kMostRecentFiles);
  EXPECT_EQ(recentFiles().front(), "/somewhere/11.obj");
  addRecentFile("/somewhere/5.obj");
  EXPECT_EQ(recentFiles().front(), "/somewhere/5.obj");
  EXPECT_EQ(recentFiles().count("/somewhere/5.obj"), 1);
}

TEST_F(DocumentFilesTest, RecentFilesThatAreMissingAreGreyAndCannotBeOpened)
{
  openSession();
  addRecentFile("/somewhere/gone.obj");
  QMenu menu;
  fillRecentMenu(menu, [&](const QString& path) { w.files.open(path); });
  ASSERT_GE(menu.actions().size(), 3);
  EXPECT_TRUE(menu.actions()[0]->text().contains("gone.obj"));
  EXPECT_FALSE(menu.actions()[0]->isEnabled());
  EXPECT_TRUE(menu.actions()[2]->isEnabled());

  const QString said = openAndAnswer("/somewhere/gone.obj", "OK");
  EXPECT_TRUE(said.contains("gone.obj"));
  EXPECT_FALSE(recentFiles().contains("/somewhere/gone.obj"));
  menu.actions()[2]->trigger();
  ASSERT_TRUE(test::waitUntil([&] { return w.files.name() == "bracket.obj"; }));
}

TEST_F(DocumentFilesTest, SelectedVerticesStayOnAMeshThatIsChosen)
{
  ASSERT_TRUE(open(sample("bracket.obj")));
  w.editor.selectVertices({10, 11, 12});
  w.answers = {sample("quads.obj"), w.path("part.holdfast")};
  w.files.guideMeshDialog({});
  ASSERT_TRUE(test::waitUntil([&] { return w.editor.list().constraints.size() == 1; }));
  EXPECT_EQ(w.questions.back().title, "Choose the mesh to stay on");
  EXPECT_EQ(w.editor.history().undoName(), "add slide 1");
  const auto& slide = std::get<SlideConstraint>(w.editor.list().constraints.front().what);
  EXPECT_EQ(std::get<OnMesh>(slide.on).path, w.path("quads.obj"));
  EXPECT_TRUE(w.editor.selection() == Selection{VertexIds{{}}}) << "it is the constraint's now";
  ASSERT_TRUE(w.files.save());
  EXPECT_NE(test::bytesOf(w.path("part.holdfast")).find(R"("on": {"mesh": "quads.obj"})"), std::string::npos);
  ASSERT_TRUE(open(w.path("part.holdfast")));
  const auto& again = std::get<SlideConstraint>(w.editor.list().constraints.front().what);
  EXPECT_NE(std::get<OnMesh>(again.on).surface, nullptr);
}

TEST_F(DocumentFilesTest, AMeshToStayOnThatCannotBeReadIsNamed)
{
  ASSERT_TRUE(open(sample("bracket.obj")));
  w.editor.selectVertices({10, 11, 12});
  w.answers = {w.folder.file("broken.ply", "ply\nno header")};
  QString said;
  const DialogAnswer answer("messageBox", [&](QDialog& box) {
    said = test::textOf(box);
    test::clickButton(box, "OK");
  });
  w.files.guideMeshDialog({});
  ASSERT_TRUE(test::waitUntil([&] { return answer.isGiven(); }));
  EXPECT_TRUE(said.contains("broken.ply")) << said.toStdString();
  EXPECT_TRUE(w.editor.list().constraints.empty());
}

TEST_F(DocumentFilesTest, AFileIsChosenByTypingItsName)
{
  const fs::path mesh = sample("quads.obj");
  w.files.setChooser(chooseFile);
  const DialogAnswer answer("fileDialog", [&](QDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    ASSERT_NE(name, nullptr);
    name->clear();
    test::type(*name, mesh.string().c_str());
    test::clickButton(dialog, "Open");
  });
  w.files.openDialog();
  ASSERT_TRUE(test::waitUntil([&] { return w.editor.isOpen(); }));
  EXPECT_EQ(w.editor.mesh().path, mesh);
}

}  // namespace
}  // namespace holdfast
