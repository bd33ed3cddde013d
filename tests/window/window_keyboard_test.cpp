#include <QAbstractScrollArea>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>
#include <memory>

#include <QtTest/QTest>
#include <gmock/gmock.h>

#include <holdfast/window/files/autosave.h>
#include <holdfast/window/files/import_dialog.h>
#include <holdfast/window/table/constraint_table_model.h>

#include "dialogs.h"
#include "gestures.h"
#include "support/source_tree.h"
#include "window_user.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;
using testing::IsEmpty;

/// The window, used by keys alone.
class KeyboardInWindow : public test::WindowUser {
 protected:
  /// Opens the bracket with Ctrl+O.
  void openByKeys()
  {
    chooseFile(test::dataFolder() + "/bracket.obj");
    key(Qt::Key_O, Qt::ControlModifier);
    ASSERT_TRUE(test::waitUntil([this] { return editor().isOpen(); }));
    ASSERT_TRUE(settle());
  }

  void TearDown() override
  {
    if (editor().isOpen()) editor().markSaved(editor().history().state());
  }
};

TEST_F(KeyboardInWindow, MakesAHandleOfWhatIsSelectedAndShiftsIt)
{
  openByKeys();
  key(Qt::Key_I);
  ASSERT_EQ(static_cast<Index>(editor().selectedVertices().size()), editor().model()->mesh.vertexCount());
  key(Qt::Key_H);
  ASSERT_EQ(list().constraints.size(), 1u);
  ASSERT_TRUE(tabTo(table()));
  key(Qt::Key_Home, Qt::ControlModifier);
  goToColumn(Table::X);
  typeIntoCell("3.5");
  EXPECT_EQ(std::get<HandleConstraint>(list().constraints[0].what).translate, Vector3(3.5, 0, 0));
  EXPECT_EQ(editor().positions().col(0), (editor().model()->mesh.positions.col(0).array() + 3.5).matrix());
}

TEST_F(KeyboardInWindow, ToolsHearTheirLettersThoughMenusUseThemToo)
{
  openByKeys();
  viewport().setFocus();
  holdVertex(freeVertex());
  ASSERT_EQ(editor().selectedConstraints().size(), 1u);
  // E: hold points of edges; not: disable what is selected.
  const QString before = find<QWidget>("statusLine").findChild<QWidget*>("statusHint")->toolTip();
  key(Qt::Key_E);
  EXPECT_TRUE(list().constraints[0].isEnabled);
  EXPECT_EQ(editor().history().undoName(), "add " + list().constraints[0].name);
  // With another tool the letter is the menu's.
  key(Qt::Key_S);
  key(Qt::Key_E);
  EXPECT_FALSE(list().constraints[0].isEnabled);
}

TEST_F(KeyboardInWindow, TypedLettersAreNoShortcuts)
{
  openByKeys();
  key(Qt::Key_I);
  ASSERT_FALSE(editor().selectedVertices().empty());
  auto& filter = find<QLineEdit>("constraintFilter");
  ASSERT_TRUE(tabTo(filter));
  keys("fhr");
  EXPECT_EQ(filter.text(), "fhr");
  EXPECT_TRUE(list().constraints.empty());
}

TEST_F(KeyboardInWindow, TabGoesThroughAllThatIsShownAndReturns)
{
  openByKeys();
  ASSERT_TRUE(tabTo(table()));
  ASSERT_TRUE(tabTo(viewport()));
  ASSERT_TRUE(tabTo(table()));
}

TEST_F(KeyboardInWindow, EscapeInAnOpenListClosesTheListAndNothingElse)
{
  openByKeys();
  key(Qt::Key_I);
  auto& list = find<QComboBox>("constraintStatusFilter");
  ASSERT_TRUE(tabTo(list));
  key(Qt::Key_Space);
  ASSERT_TRUE(test::waitUntil([&] { return list.view()->isVisible(); }));
  key(Qt::Key_Escape);
  EXPECT_TRUE(test::waitUntil([&] { return !list.view()->isVisible(); }));
  EXPECT_FALSE(editor().selectedVertices().empty());
  key(Qt::Key_Escape);
  EXPECT_TRUE(editor().selectedVertices().empty());
}

TEST_F(KeyboardInWindow, CtrlYRedoes)
{
  openByKeys();
  key(Qt::Key_I);
  key(Qt::Key_F);
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(list().constraints.empty());
  key(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(list().constraints.size(), 1u);
}

TEST_F(KeyboardInWindow, ADialogGivesTheKeysBack)
{
  openByKeys();
  viewport().setFocus();
  QTimer::singleShot(0, &window, [this] {
    ASSERT_TRUE(test::waitUntil([] { return QApplication::activeModalWidget() != nullptr; }));
    QWidget* dialog = QApplication::activeModalWidget();
    dialog->activateWindow();
    ASSERT_TRUE(test::waitUntil([=] { return dialog->isActiveWindow(); }));
    QTest::keyClick(dialog, Qt::Key_Escape);
  });
  trigger("help");
  ASSERT_TRUE(test::waitUntil([this] { return window.isActiveWindow(); }));
  EXPECT_EQ(QApplication::focusWidget(), &viewport());
  key(Qt::Key_I);
  EXPECT_FALSE(editor().selectedVertices().empty());
}

/// Names of actions whose tip is missing, says no more than their text, or shows the mark of a mnemonic.
std::vector<std::string> actionsWithoutTips(const QWidget& window)
{
  std::vector<std::string> found;
  for (const QAction* action : window.findChildren<QAction*>()) {
    // Of menus within menus, and of Qt's own line edits, scroll bars and tool bars.
    if (action->isSeparator() || action->menu() != nullptr || qobject_cast<QLineEdit*>(action->parent()) != nullptr)
      continue;
    const QString text = action->text().remove('&').remove(QStringLiteral("…"));
    const QString tip = action->toolTip();
    if (tip.isEmpty() || tip.contains('&') || tip == text || tip == action->text())
      found.push_back((action->objectName() + ": " + action->text() + " – " + tip).toStdString());
  }
  return found;
}

/// Tells whether this is a part of one of Qt's own widgets, which speaks for it.
bool isPart(const QWidget& widget)
{
  if (widget.objectName().startsWith("qt_") || widget.inherits("QComboBoxListView") ||
      qobject_cast<const QTabBar*>(&widget) != nullptr)
    return true;
  for (const char* whole : {"QAbstractItemView", "QLineEdit", "QTabBar", "QAbstractSpinBox", "QComboBox"})
    if (widget.parentWidget() != nullptr && widget.parentWidget()->inherits(whole)) return true;
  const auto* area = qobject_cast<const QAbstractScrollArea*>(widget.parentWidget());
  return area != nullptr && area->viewport() == &widget;
}

/// Tells whether a user can press, type into or choose from it, or get to it by keys.
bool isControl(const QWidget& widget)
{
  if ((widget.focusPolicy() & Qt::TabFocus) != 0) return true;
  for (const char* kind : {"QAbstractButton", "QLineEdit", "QComboBox", "QAbstractSpinBox", "QAbstractItemView"})
    if (widget.inherits(kind)) return true;
  return false;
}

/// Controls that no screen reader could name.
std::vector<std::string> namelessWidgets(const QWidget& window)
{
  std::vector<std::string> found;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!isControl(*widget) || widget->focusProxy() != nullptr || isPart(*widget)) continue;
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
    if (spoken != nullptr && !spoken->text(QAccessible::Name).trimmed().isEmpty()) continue;
    found.push_back(widget->metaObject()->className() + (" " + widget->objectName()).toStdString() + " in " +
                    widget->parentWidget()->metaObject()->className());
  }
  return found;
}

class NamesInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.conflict.constraints.json");
    // Panels make some of their controls when they are first looked at.
    for (const char* panel : {"Colours", "Rotations", "Distributions", "Conflicts", "Mesh", "Solution"})
      openPanel(panel);
    openPanel("Selected");
    openPanel("Constraints");
    for (Index k = 0; k < static_cast<Index>(list().constraints.size()); ++k) editor().selectConstraints({k});
    ASSERT_TRUE(settle());
  }
};

TEST_F(NamesInWindow, EveryActionHasATip)
{
  EXPECT_THAT(actionsWithoutTips(window), IsEmpty());
}

/// Texts of buttons and actions with a capital letter after the first word.
std::vector<std::string> titlesInCapitals(const QWidget& window)
{
  QStringList texts;
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) texts << button->text();
  for (const QAction* action : window.findChildren<QAction*>())
    if (qobject_cast<QLineEdit*>(action->parent()) == nullptr) texts << action->text();
  std::vector<std::string> found;
  for (const QString& text : texts)
    // Names of constraints and of the program aside.
    if (QString(text).remove('&').remove(QRegularExpression("“.*”|Holdfast")).contains(QRegularExpression(" [A-Z]")))
      found.push_back(text.toStdString());
  return found;
}

TEST_F(NamesInWindow, ButtonsAndActionsAreInSentenceCase)
{
  EXPECT_THAT(titlesInCapitals(window), IsEmpty());
  new QPushButton("Give Each Its Own", &window);
  EXPECT_THAT(titlesInCapitals(window), testing::ElementsAre("Give Each Its Own"));
}

TEST_F(NamesInWindow, EveryControlHasAName)
{
  EXPECT_THAT(namelessWidgets(window), IsEmpty());
}

TEST_F(NamesInWindow, EveryControlOfADialogHasAName)
{
  for (const auto& [action, dialog] : {std::pair("help", "helpDialog"),
                                       {"commands", "commandDialog"},
                                       {"preferences", "preferencesDialog"},
                                       {"exportPicture", "pictureDialog"}}) {
    const test::DialogAnswer answer(dialog, [](QDialog& shown) {
      EXPECT_THAT(namelessWidgets(shown), IsEmpty());
      shown.close();
    });
    trigger(action);
    EXPECT_TRUE(test::waitUntil([&] { return answer.isGiven(); })) << action;
  }
  trigger("manual");
  ASSERT_TRUE(test::waitUntil([] { return test::findDialog("manual") != nullptr; }));
  EXPECT_THAT(namelessWidgets(*test::findDialog("manual")), IsEmpty());
  test::findDialog("manual")->close();
  const std::unique_ptr<QDialog> import(
      newImportDialog(editor(), test::dataFolder() + "/bracket.measured.csv", &window));
  EXPECT_THAT(namelessWidgets(*import), IsEmpty());
  const std::unique_ptr<QDialog> recovery(newRecoveryDialog({{}}, [](const Recoverable&) {}));
  EXPECT_THAT(namelessWidgets(*recovery), IsEmpty());
}

TEST_F(NamesInWindow, WhatHasNoneIsFound)
{
  const auto widgets = namelessWidgets(window).size();
  const auto actions = actionsWithoutTips(window).size();
  auto* bare = new QToolButton(&window);
  bare->setFocusPolicy(Qt::NoFocus);
  bare->addAction(new QAction("&Bare", bare));
  EXPECT_EQ(namelessWidgets(window).size(), widgets + 1);
  EXPECT_EQ(actionsWithoutTips(window).size(), actions + 1);
}

}  // namespace
}  // namespace holdfast
