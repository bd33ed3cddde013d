#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <chrono>
#include <memory>
#include <set>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include <holdfast/window/controls/theme.h>
#include <holdfast/window/files/bundled_files.h>
#include <holdfast/window/files/document_exports.h>
#include <holdfast/window/files/recent_files.h>
#include <holdfast/window/table/constraint_table_model.h>

#include "dialogs.h"
#include "files_window.h"
#include "support/source_tree.h"
#include "window_user.h"

namespace holdfast {
namespace {

using test::DialogAnswer;

/// Finds a command by words, and runs it with Enter.
void runCommand(QWidget& window, const char* words)
{
  // Without a window manager a dialog that closes leaves no window active.
  window.activateWindow();
  ASSERT_TRUE(test::waitUntil([&] { return window.isActiveWindow(); }));
  const DialogAnswer answer("commandDialog", [words](QDialog& dialog) {
    auto& text = *dialog.findChild<QLineEdit*>("commandText");
    test::type(text, words);
    test::pressKey(text, Qt::Key_Return);
  });
  QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
}

/// A window as the program makes it, on the screen and with the keys.
std::unique_ptr<MainWindow> nextStart()
{
  auto window = std::make_unique<MainWindow>();
  window->resize(1100, 900);
  window->remember();
  EXPECT_TRUE(test::showAndWait(*window));
  window->activateWindow();
  EXPECT_TRUE(test::waitUntil([&] { return window->isActiveWindow(); }));
  return window;
}

QHeaderView& titlesOf(MainWindow& window)
{
  return *window.findChild<QTableView*>("constraintTable")->horizontalHeader();
}

class RememberedWindow : public ::testing::Test {
 protected:
  ~RememberedWindow() override { apply(Appearance::System); }

  test::OwnSettings settings;
};

TEST_F(RememberedWindow, LooksAsItDidWhenItWasClosed)
{
  const bool isDarkFirst = isDark(QApplication::palette());
  auto window = nextStart();
  const int wide = titlesOf(*window).sectionSize(1);
  runCommand(*window, isDarkFirst ? "colours light" : "colours dark");
  runCommand(*window, "panels distributions");
  runCommand(*window, "of the view");
  titlesOf(*window).resizeSection(1, wide + 40);
  window->resize(1250, 850);
  auto colors = window->viewport().colors();
  colors.map = ColorMap::Grey;
  colors.bands = 5;
  window->viewport().setColors(colors);
  auto display = window->viewport().display();
  display.legend = LegendSide::Left;
  window->viewport().setDisplay(display);
  window->close();

  window = nextStart();
  EXPECT_NE(isDark(QApplication::palette()), isDarkFirst);
  EXPECT_TRUE(window->findChild<QDockWidget*>("histogramDock")->isHidden());
  EXPECT_EQ(window->gizmo().axes(), GizmoAxes::View);
  EXPECT_EQ(titlesOf(*window).sectionSize(1), wide + 40);
  EXPECT_EQ(window->size(), QSize(1250, 850));
  EXPECT_EQ(window->viewport().colors().map, ColorMap::Grey);
  EXPECT_EQ(window->findChild<QComboBox*>("colorMap")->currentText(), "Greys");
  EXPECT_EQ(window->viewport().colors().bands, 5);
  EXPECT_EQ(window->findChild<QSpinBox*>("colorBands")->value(), 5);
  EXPECT_EQ(window->viewport().display().legend, LegendSide::Left);
  EXPECT_EQ(window->findChild<QComboBox*>("legendSide")->currentText(), "At the left");

  addRecentFile("/part.obj");
  rememberFolder("export", "/usr/bin/env");
  ASSERT_EQ(inLastFolder("export", "/part.obj"), "/usr/bin/part.obj");
  runCommand(*window, "reset all settings");
  EXPECT_EQ(inLastFolder("export", "/part.obj"), "/part.obj");
  EXPECT_EQ(recentFiles().size(), 1) << "no setting";
  EXPECT_EQ(isDark(QApplication::palette()), isDarkFirst);
  EXPECT_FALSE(window->findChild<QDockWidget*>("histogramDock")->isHidden());
  EXPECT_EQ(window->gizmo().axes(), GizmoAxes::World);
  EXPECT_EQ(titlesOf(*window).sectionSize(1), wide);
  EXPECT_EQ(window->viewport().colors().map, ColorSettings{}.map);
  EXPECT_EQ(window->viewport().colors().bands, 0);
  EXPECT_EQ(window->viewport().display().legend, LegendSide::Right);
  EXPECT_TRUE(test::waitUntil([&] { return window->size() == QSize(1100, 900); }));
}

TEST_F(RememberedWindow, KeepsAndResetsHiddenColumnsAndSwitches)
{
  const int residual = ConstraintTableModel::Residual;
  const auto isHidden = [&](MainWindow& window) { return titlesOf(window).isSectionHidden(residual); };
  const auto isThrough = [](MainWindow& window) { return window.findChild<QAction*>("reachThrough")->isChecked(); };
  auto window = nextStart();
  ASSERT_FALSE(isHidden(*window));
  ASSERT_FALSE(isThrough(*window));
  const QString column = "column" + titlesOf(*window).model()->headerData(residual, Qt::Horizontal).toString();
  window->findChild<QAction*>(column)->trigger();
  window->findChild<QAction*>("reachThrough")->trigger();
  ASSERT_TRUE(isHidden(*window));
  window->close();

  window = nextStart();
  EXPECT_TRUE(isHidden(*window));
  EXPECT_FALSE(window->findChild<QAction*>(column)->isChecked()) << "its menu knows";
  EXPECT_TRUE(isThrough(*window));
  runCommand(*window, "reset all settings");
  EXPECT_FALSE(isHidden(*window));
  EXPECT_TRUE(window->findChild<QAction*>(column)->isChecked());
  EXPECT_FALSE(isThrough(*window));
  window->close();
  window = nextStart();
  EXPECT_FALSE(isHidden(*window));
  EXPECT_FALSE(isThrough(*window));
}

TEST_F(RememberedWindow, KeepsAPanelThatIsInFront)
{
  auto window = nextStart();
  window->findChild<QDockWidget*>("conflictsDock")->raise();
  window->close();
  window = nextStart();
  auto* panel = window->findChild<QDockWidget*>("conflictsDock")->widget();
  EXPECT_TRUE(test::waitUntil([panel] { return panel->isVisible(); }));
}

TEST_F(RememberedWindow, EndsWhileACellIsEdited)
{
  auto window = nextStart();
  NoProgress quiet;
  DocumentState state;
  state.list.constraints.push_back({"held", true, PointConstraint{AtVertex{0}, Move{}}});
  window->editor().open(loadMesh(test::dataFolder() + "/bracket.obj", quiet), std::move(state));
  auto& table = *window->findChild<QTableView*>("constraintTable");
  table.setFocus();
  table.setCurrentIndex(table.model()->index(0, ConstraintTableModel::Name));
  table.edit(table.currentIndex());
  QPointer<QLineEdit> line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(line, nullptr);
  line->selectAll();
  test::type(*line, "other");
  std::string name;
  Editor& editor = window->editor();
  QObject::connect(&editor, &Editor::stateChanged, &editor, [&] { name = editor.list().constraints[0].name; });
  window.reset();
  EXPECT_EQ(line, nullptr);
  EXPECT_EQ(name, "other") << "taken while the document was there";
}

TEST_F(RememberedWindow, SettingsOfAnotherVersionChangeNothing)
{
  QSettings().setValue("window/view", "{");
  QSettings().setValue("window/axesWorld", "undo");
  QSettings().setValue("window/panels", "?");
  const auto window = nextStart();
  EXPECT_EQ(window->viewport().colors().map, ColorSettings{}.map);
  EXPECT_EQ(window->gizmo().axes(), GizmoAxes::World);
}

class HabitsInWindow : public test::WindowUser {
 protected:
  void SetUp() override { WindowUser::SetUp(); }
  void TearDown() override
  {
    if (editor().isOpen()) editor().markSaved(editor().history().state());
  }

  [[nodiscard]] QWidget& startPage() { return find<QWidget>("startPage"); }
  [[nodiscard]] QList<QToolButton*> entriesOf(const char* gallery)
  {
    return find<QWidget>(gallery).findChildren<QToolButton*>();
  }

  test::OwnSettings settings;
};

TEST_F(HabitsInWindow, StartPageOpensExamplesThatAreNotOverwritten)
{
  ASSERT_TRUE(startPage().isVisible());
  ASSERT_EQ(entriesOf("exampleGallery").size(), 5) << "all are found beside the program";
  for (const QToolButton* entry : entriesOf("exampleGallery")) EXPECT_FALSE(entry->icon().isNull());
  clickOn(*entriesOf("exampleGallery").front());
  ASSERT_TRUE(test::waitUntil([this] { return editor().isOpen(); }));
  ASSERT_TRUE(settle());
  EXPECT_FALSE(startPage().isVisible());
  EXPECT_EQ(list().constraints.size(), 22u);
  EXPECT_TRUE(window.files().sessionPath().empty()) << "Save asks where to";
  EXPECT_TRUE(recentFiles().isEmpty());
}

TEST_F(HabitsInWindow, StartPageScrollsAcrossAtNoWidth)
{
  const auto& bar = *startPage().findChild<QScrollArea*>()->horizontalScrollBar();
  for (const int width : {1600, 1100, 760, 1300}) {
    window.resize(width, 800);
    ASSERT_TRUE(test::waitUntil([&] { return startPage().width() == viewport().width() && window.width() == width; }));
    const auto isInside = [this](const QToolButton* entry) {
      return entry->mapTo(&startPage(), entry->rect().bottomRight()).x() < startPage().width();
    };
    EXPECT_TRUE(test::waitUntil(
        [&] { return bar.maximum() == 0 && std::ranges::all_of(entriesOf("exampleGallery"), isInside); },
        std::chrono::seconds(5)))
        << width;
  }
  const auto top = [this](int k) { return entriesOf("exampleGallery")[k]->y(); };
  EXPECT_EQ(top(0), top(1)) << "side by side where there is room";
}

TEST_F(HabitsInWindow, AnEmptyWindowSaysHowToBegin)
{
  const auto& hint = find<QLabel>("statusHint");
  EXPECT_EQ(hint.toolTip(), "Open or drop a mesh or a session, or choose an example");
  EXPECT_FALSE(find<QAction>("reachThrough").isEnabled());
  open("bar.obj");
  EXPECT_TRUE(hint.toolTip().contains("Click a constraint")) << hint.toolTip().toStdString();
  EXPECT_TRUE(find<QAction>("reachThrough").isEnabled());
  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_EQ(hint.toolTip(), "Open or drop a mesh or a session, or choose an example");
  EXPECT_FALSE(find<QAction>("reachThrough").isEnabled());
}

TEST_F(HabitsInWindow, MessagesGoWithTheirDocument)
{
  const test::TemporaryFolder folder;
  const auto& hint = find<QLabel>("statusHint");
  for (const bool isClosed : {true, false}) {
    open("bar.obj");
    chooseFile((folder.path() / "mine.holdfast").string());
    key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(test::waitUntil([this] { return !window.files().isSaving(); }));
    ASSERT_EQ(window.statusBar()->currentMessage(), "saved mine.holdfast");
    EXPECT_FALSE(hint.isVisible()) << "covered";
    isClosed ? key(Qt::Key_W, Qt::ControlModifier) : open("bracket.obj");
    EXPECT_EQ(window.statusBar()->currentMessage(), "");
    EXPECT_TRUE(hint.isVisible());
  }
}

TEST_F(HabitsInWindow, RecentFilesHavePicturesAndOpenByAClick)
{
  const test::TemporaryFolder folder;
  const auto mesh =
      QString::fromStdString(folder.file("bracket.obj", test::bytesOf(test::dataFolder() + "/bracket.obj")).string());
  window.files().open(mesh);
  ASSERT_TRUE(test::waitUntil([&] { return editor().isOpen() && QFileInfo::exists(recentPicture(mesh)); }));
  const QImage picture(recentPicture(mesh));
  EXPECT_EQ(picture.size(), kRecentPictureSize);
  std::set<QRgb> colors;
  for (int x = 0; x < picture.width(); ++x) colors.insert(picture.pixel(x, picture.height() / 2));
  EXPECT_GT(colors.size(), 20u) << "a mesh is seen";

  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(editor().isOpen());
  ASSERT_TRUE(startPage().isVisible());
  ASSERT_EQ(entriesOf("recentGallery").size(), 1);
  clickOn(*entriesOf("recentGallery").front());
  EXPECT_TRUE(test::waitUntil([this] { return editor().isOpen(); }));
}

TEST_F(HabitsInWindow, ClosingAsksAboutUnsavedWork)
{
  open("bracket.obj", "bracket.constraints.json");
  editor().markUnsaved();
  answer(QMessageBox::Cancel);
  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_TRUE(wasAsked());
  EXPECT_TRUE(editor().isOpen());
}

TEST_F(HabitsInWindow, CommandsAreFoundByWordsAndShowTheirKeys)
{
  open("bracket.obj");
  const DialogAnswer look("commandDialog", [](QDialog& dialog) {
    auto& rows = *dialog.findChild<QTreeWidget*>("commandList");
    std::set<QString> keys;
    for (int k = 0; k < rows.topLevelItemCount(); ++k) keys.insert(rows.topLevelItem(k)->text(1));
    for (const char* known : {"Ctrl+O", "Shift+S", "F1", "Alt+Up", "[, ]", "X, Y, Z"})
      EXPECT_TRUE(keys.contains(known)) << known;
    auto& text = *dialog.findChild<QLineEdit*>("commandText");
    test::type(text, "picture of nothing at all");
    EXPECT_EQ(rows.topLevelItemCount(), 0);
    test::pressKey(text, Qt::Key_Return);
    EXPECT_TRUE(dialog.isVisible()) << "nothing to run";
    text.clear();
    test::type(text, "invert");
    ASSERT_NE(rows.currentItem(), nullptr);
    EXPECT_EQ(rows.currentItem()->text(0), QString::fromUtf8("Select › Invert"));
    test::pressKey(text, Qt::Key_Return);
  });
  key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(static_cast<Index>(editor().selectedVertices().size()), editor().model()->mesh.vertexCount());
}

TEST_F(HabitsInWindow, NoKeyHasTwoCommands)
{
  std::set<QString> keys;
  for (const QAction* action : window.findChildren<QAction*>()) {
    if (action->shortcut().isEmpty() || action->shortcutContext() != Qt::WindowShortcut) continue;
    EXPECT_TRUE(keys.insert(action->shortcut().toString()).second) << action->text().toStdString();
  }
  EXPECT_GT(keys.size(), 40u);
}

TEST_F(HabitsInWindow, PreferencesApplyAtOnce)
{
  open("bar.obj");
  key(Qt::Key_Comma, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("preferencesDialog") != nullptr; }));
  auto& dialog = *test::findDialog("preferencesDialog");
  auto& axes = *dialog.findChild<QComboBox*>("axesWorldChoice");
  chooseEntry(axes, 2);
  EXPECT_EQ(window.gizmo().axes(), GizmoAxes::View);
  auto& unit = *dialog.findChild<QLineEdit*>("unit");
  test::type(unit, "mm");
  test::pressKey(unit, Qt::Key_Return);
  EXPECT_EQ(list().units, "mm");
  auto& decimals = *dialog.findChild<QComboBox*>("decimals");
  chooseEntry(decimals, 4);
  EXPECT_EQ(decimals.currentText(), "0.001");
  EXPECT_EQ(editor().decimals(), 3);
  EXPECT_FALSE(editor().history().undoName() == "decimals") << "no edit";
  dialog.close();
  ASSERT_TRUE(settle());
  trigger("undo");
  EXPECT_EQ(list().units, "");

  window.files().open(QString::fromStdString(test::dataFolder() + "/bracket.obj"));
  ASSERT_TRUE(test::waitUntil([this] { return !window.files().isOpening(); }));
  EXPECT_EQ(list().units, "mm") << "of meshes that are opened later";
  EXPECT_EQ(editor().decimals(), 3) << "the same";
}

TEST_F(HabitsInWindow, ManualIsAtHand)
{
  key(Qt::Key_F1, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("manual") != nullptr; }));
  auto& dialog = *test::findDialog("manual");
  EXPECT_TRUE(dialog.findChild<QTextBrowser*>("manualText")->toPlainText().contains("The mouse in the picture"));
  dialog.close();
}

TEST(HabitsOfFiles, FoldersAreRememberedForEachPurpose)
{
  test::FilesWindow w;
  ASSERT_TRUE(w.open(w.sample("bracket.obj")));
  w.holdVertex(0);
  ASSERT_TRUE(w.waitForCurrent());
  const test::TemporaryFolder elsewhere;
  DocumentExports exports(w.editor, &w.window);
  exports.setChooser(w.chooser());
  w.answers = {elsewhere.path() / "report.json"};
  exports.exportReport();
  ASSERT_TRUE(test::waitUntil([&] { return !exports.isWriting(); }));
  exports.exportReport();
  EXPECT_EQ(w.questions.back().suggestion.toStdString(), (elsewhere.path() / "bracket.report.json").string());
  w.files.importDialog();
  EXPECT_EQ(w.questions.back().suggestion.toStdString(), w.folder.path().string()) << "nothing was imported yet";
}

}  // namespace
}  // namespace holdfast
