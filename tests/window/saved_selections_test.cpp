// Selections that are kept under names: the menu, the panel and its keys.

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include "dialogs.h"
#include "gestures.h"
#include "support/temporary_folder.h"
#include "window_user.h"

namespace holdfast {
namespace {

class SavedSelectionsInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    viewport().setFocus();
  }

  void TearDown() override
  {
    if (editor().isOpen()) editor().markSaved(editor().history().state());
  }

  [[nodiscard]] QTreeWidget& tree() { return find<QTreeWidget>("selectionTree"); }
  [[nodiscard]] const std::vector<SavedSelection>& saved() { return editor().annotations().selections; }
  [[nodiscard]] bool isEditing() { return tree().viewport()->findChild<QLineEdit*>() != nullptr; }

  /// Ctrl+G, the name, Enter.
  void saveAs(const std::vector<Index>& vertices, const char* name)
  {
    editor().selectVertices(vertices);
    viewport().setFocus();
    key(Qt::Key_G, Qt::ControlModifier);
    ASSERT_TRUE(test::waitUntil([this] { return isEditing(); }));
    typeName(name);
  }

  void typeName(const char* name)
  {
    auto* line = tree().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr);
    line->selectAll();
    test::type(*line, name);
    test::pressKey(*line, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([this] { return !isEditing(); }));
  }

  void goTo(int row)
  {
    tree().setFocus();
    tree().setCurrentItem(tree().topLevelItem(row));
  }

  [[nodiscard]] QString refusal()
  {
    auto& label = find<QLabel>("selectionRefusal");
    return label.isVisible() ? label.text() : QString();
  }
};

TEST_F(SavedSelectionsInWindow, AreNamedAtOnceAndSelectedAgain)
{
  saveAs({1, 2, 3}, "rim");
  saveAs({7, 8}, "foot");
  ASSERT_EQ(saved().size(), 2u);
  EXPECT_EQ(saved()[0].name, "rim");
  EXPECT_EQ(std::get<VertexIds>(saved()[1].select.what).ids, (std::vector<Index>{7, 8}));
  EXPECT_EQ(tree().topLevelItem(0)->text(1), "3 vertices");
  editor().selectVertices({});

  const QRect row = tree().visualItemRect(tree().topLevelItem(0));
  test::doubleClick(*tree().viewport(), row.center());
  EXPECT_EQ(editor().selectedVertices(), (std::vector<Index>{1, 2, 3}));
  goTo(1);
  key(Qt::Key_Return);
  EXPECT_EQ(editor().selectedVertices(), (std::vector<Index>{7, 8}));
  goTo(0);
  clickOn(find<QPushButton>("selectionSelect"));
  EXPECT_EQ(editor().selectedVertices(), (std::vector<Index>{1, 2, 3}));
  // The menu has them as well.
  auto& menu = find<QMenu>("savedSelections");
  ASSERT_EQ(menu.actions().size(), 2);
  EXPECT_EQ(menu.actions()[1]->text(), "foot");
  menu.actions()[1]->trigger();
  EXPECT_EQ(editor().selectedVertices(), (std::vector<Index>{7, 8}));
}

TEST_F(SavedSelectionsInWindow, EveryChangeIsOneEditThatIsNotSolved)
{
  const auto deformation = editor().deformation();
  editor().selectVertices({5});
  openPanel("Selections");
  clickOn(find<QPushButton>("selectionSave"));
  EXPECT_EQ(editor().history().undoName(), "save selection 1");
  EXPECT_TRUE(window.isWindowModified());
  goTo(0);
  key(Qt::Key_F2);
  typeName("ear");
  EXPECT_EQ(editor().history().undoName(), "rename selection 1 to ear");
  goTo(0);
  key(Qt::Key_Delete);
  EXPECT_TRUE(saved().empty());
  EXPECT_EQ(editor().history().undoName(), "delete ear");
  EXPECT_FALSE(find<QMenu>("savedSelections").isEnabled());
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(saved().size(), 1u);
  EXPECT_EQ(tree().topLevelItem(0)->text(0), "ear");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(tree().topLevelItem(0)->text(0), "selection 1");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(saved().empty());
  EXPECT_FALSE(window.isWindowModified());
  EXPECT_EQ(editor().deformation(), deformation);
  EXPECT_TRUE(editor().isCurrent());
}

TEST_F(SavedSelectionsInWindow, NamesThatAreEmptyOrTakenAreRefused)
{
  saveAs({1, 2, 3}, "rim");
  saveAs({7, 8}, "foot");
  const auto state = editor().history().state();
  for (const auto& [name, words] : {std::pair("rim", "another selection has this name"), {" ", "is empty"}}) {
    goTo(1);
    key(Qt::Key_F2);
    typeName(name);
    EXPECT_TRUE(refusal().contains(words)) << refusal().toStdString();
    EXPECT_EQ(tree().topLevelItem(1)->text(0), "foot");
  }
  EXPECT_EQ(editor().history().state(), state);
  key(Qt::Key_F2);
  typeName("toe");
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(saved()[1].name, "toe");
}

TEST_F(SavedSelectionsInWindow, ACurveComesBackAsACurve)
{
  const InsideCurve curve{{AtVertex{0}, AtVertex{200}, AtVertex{400}}, CurveSide::Smaller};
  const std::vector<Index> inside = editor().mesh().selector->select({curve}, {});
  editor().selectVertices(inside, Selection{curve});
  trigger("saveSelection");
  editor().selectVertices({});
  find<QMenu>("savedSelections").actions()[0]->trigger();
  EXPECT_EQ(editor().selectedVertices(), inside);
  EXPECT_TRUE(std::holds_alternative<InsideCurve>(editor().selection().what));
}

TEST_F(SavedSelectionsInWindow, WhatTheMeshDoesNotHaveIsToldAndKept)
{
  editor().setSavedSelections("save", {{"elsewhere", {VertexIds{{0, 1'000'000}}}}});
  editor().selectVertices({4});
  {
    QString said;
    const test::DialogAnswer answer("messageBox", [&](QDialog& box) {
      said = test::textOf(box);
      test::clickButton(box, "OK");
    });
    find<QMenu>("savedSelections").actions()[0]->trigger();
    EXPECT_TRUE(said.contains("1000000")) << said.toStdString();
  }
  openPanel("Selections");
  goTo(0);
  key(Qt::Key_Return);
  EXPECT_TRUE(refusal().contains("1000000")) << refusal().toStdString();
  EXPECT_EQ(editor().selectedVertices(), (std::vector<Index>{4}));
  EXPECT_EQ(saved().size(), 1u);
}

}  // namespace
}  // namespace holdfast
