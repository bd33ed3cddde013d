#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTimer>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include <holdfast/window/table/constraint_table_model.h>

#include "dialogs.h"
#include "files_window.h"
#include "support/source_tree.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// A dialog that takes the keys: how it is opened, and what it is called. Each ends by Escape, and by Enter or a
/// button.
struct KeyedDialog {
  const char* name;
  const char* action;
  const char* title;
  const char* text = "";    // typed before Enter
  const char* button = "";  // in place of Enter, where that closes nothing
};

void PrintTo(const KeyedDialog& dialog, std::ostream* stream)
{
  *stream << dialog.title;
}

class DialogInWindow : public test::WindowUser, public ::testing::WithParamInterface<KeyedDialog> {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    mesh = folder.file("bracket.obj", test::bytesOf(test::dataFolder() + "/bracket.obj")).string();
    window.files().open(QString::fromStdString(mesh));
    ASSERT_TRUE(test::waitUntil([this] { return editor().isOpen(); }));
    ASSERT_TRUE(settle());
    if (QString(GetParam().name) == "OpenFile") return;
    const QString measured = QString::fromStdString(test::dataFolder() + "/bracket.measured.csv");
    const QString missing = QString::fromStdString(folder.path().string() + "/missing.obj");
    const QString saved = QString::fromStdString(folder.path().string() + "/saved");
    const auto answer = [=](QWidget*, const FileQuestion& question) {
      return question.purpose == FileQuestion::Purpose::Write ? saved
             : question.title.startsWith("Import")            ? measured
                                                              : missing;
    };
    window.files().setChooser(answer);
    window.exports().setChooser(answer);
  }

  void TearDown() override
  {
    if (editor().isOpen()) editor().markSaved(editor().history().state());
  }

  /// Opens the dialog, and ends it by a key once it has the keys of the display. Its title.
  [[nodiscard]] QString endBy(Qt::Key key)
  {
    QString title;
    bool isEnded = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &window, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isActiveWindow() || QApplication::focusWidget() == nullptr) return;
      timer.stop();
      title = dialog->windowTitle();
      isEnded = true;
      if (key == Qt::Key_Return && *GetParam().button != 0) return test::clickButton(*dialog, GetParam().button);
      if (key == Qt::Key_Return) QTest::keyClicks(QApplication::focusWidget(), GetParam().text);
      QTest::keyClick(QApplication::focusWidget(), key);
    });
    timer.start(5);
    trigger(GetParam().action);
    EXPECT_TRUE(test::waitUntil([&] { return isEnded && QApplication::activeModalWidget() == nullptr; }));
    return title;
  }

  test::OwnSettings settings;
  test::TemporaryFolder folder;
  std::string mesh;
};

TEST_P(DialogInWindow, GivesTheKeysBackToWhatHadThem)
{
  for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_Return})
    for (QWidget* owner : std::initializer_list<QWidget*>{&viewport(), &find<QLineEdit>("constraintFilter")}) {
      if (QString(GetParam().name) == "SaveQuestion") editor().markUnsaved();
      owner->setFocus();
      ASSERT_EQ(QApplication::focusWidget(), owner);
      EXPECT_EQ(endBy(key), GetParam().title);
      EXPECT_TRUE(test::waitUntil([&] { return window.isActiveWindow(); }));
      EXPECT_TRUE(
          test::waitUntil([&] { return QApplication::focusWidget() == owner; }, std::chrono::milliseconds(2000)))
          << owner->objectName().toStdString() << (key == Qt::Key_Escape ? ", Escape" : ", Enter");
      ASSERT_TRUE(test::waitUntil([this] { return !window.files().isOpening() && !window.exports().isWriting(); }));
      if (!editor().isOpen()) return;  // closed once it was saved
    }
}

INSTANTIATE_TEST_SUITE_P(, DialogInWindow,
                         ::testing::Values(KeyedDialog{"Gestures", "help", "Ten gestures"},
                                           KeyedDialog{"Commands", "commands", "Commands and keys", "invert"},
                                           KeyedDialog{"Preferences", "preferences", "Preferences", "", "Close"},
                                           KeyedDialog{"About", "about", "About Holdfast"},
                                           KeyedDialog{"Picture", "exportPicture", "Export a picture"},
                                           KeyedDialog{"Import", "import", "Import bracket.measured.csv"},
                                           KeyedDialog{"Problem", "open", "Holdfast"},
                                           KeyedDialog{"SaveQuestion", "close", "Holdfast"},
                                           KeyedDialog{"OpenFile", "open", "Open a mesh or a session", "bracket.obj"}),
                         [](const auto& each) { return std::string(each.param.name); });

class LineOfWindow : public test::WindowUser {
 protected:
  /// Hints that do not fit beside what the line says of the selection, with the tools as they are.
  [[nodiscard]] std::vector<std::string> cutHints(const std::vector<const char*>& keysOfTools)
  {
    std::vector<std::string> cut;
    for (const char* pressed : keysOfTools) {
      viewport().setFocus();
      keys(pressed);
      EXPECT_TRUE(settle());
      QApplication::processEvents();
      const auto& hint = find<QLabel>("statusHint");
      if (hint.text() != hint.toolTip())
        cut.push_back(std::string(pressed) + " " + std::to_string(hint.width()) + " of " +
                      std::to_string(hint.fontMetrics().horizontalAdvance(hint.toolTip())) + ": " +
                      hint.toolTip().toStdString());
    }
    return cut;
  }
};

TEST_F(LineOfWindow, HintsOfAllToolsFitAt1280)
{
  window.resize(1280, 800);
  open("bracket.obj", "bracket.constraints.json");
  ASSERT_TRUE(test::waitUntil([this] { return window.width() == 1280; }));
  const std::vector<const char*> tools{"s", "pa", "pv", "pe", "pf", "k", "b", "m", "mt", "t",
                                       "l", "lt", "t",  "w",  "wn", "n", "c", "d", "q"};
  EXPECT_EQ(cutHints(tools), std::vector<std::string>());
  // The line says more of a selection than of a solution.
  key(Qt::Key_I);
  ASSERT_TRUE(test::waitUntil([this] { return find<QLabel>("statusSelection").isVisible(); }));
  EXPECT_EQ(cutHints(tools), std::vector<std::string>());
  window.resize(700, 800);
  ASSERT_TRUE(test::waitUntil([this] { return window.width() < 1100; }));
  EXPECT_FALSE(cutHints({"w", "b"}).empty()) << "a narrow window cuts some";
}

TEST_F(LineOfWindow, ForceIsTheOneWordOfColoursTableAndOutcome)
{
  open("bracket.obj", "bracket.constraints.json");
  editor().selectConstraints({0});
  openPanel("Selected");
  const QString title = table().model()->headerData(ConstraintTableModel::Force, Qt::Horizontal).toString();
  EXPECT_EQ(title, "Force");
  openPanel("Colours");
  EXPECT_EQ(find<QComboBox>("colorField").itemText(static_cast<int>(ColorBy::Force)), title);
  EXPECT_EQ(coloringOf(*editor().model(), *editor().deformation(), ColorBy::Force, "")->scale.title, "force");
  QStringList labels;
  for (const QLabel* label : window.findChildren<QLabel*>()) labels << label->text();
  EXPECT_TRUE(labels.contains(title)) << "of the outcome";
}

}  // namespace
}  // namespace holdfast
