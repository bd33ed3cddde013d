#include <QLabel>
#include <QPushButton>

#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/panels/panels.h>

#include "gestures.h"
#include "open_document.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

/// The bracket with four contradicting constraints and three that repeat others.
class ConflictPanelOfBracket : public ::testing::Test {
 protected:
  void SetUp() override
  {
    ASSERT_TRUE(test::openData(editor, "bracket.obj", "bracket.conflict.constraints.json"));
    panel.resize(520, 700);
    ASSERT_TRUE(test::showAndWait(panel));
  }

  [[nodiscard]] Card* card(const char* name)
  {
    for (Card* card : panel.findChildren<Card*>())
      if (card->isVisible() && card->findChild<QLabel*>("cardTitle")->text().startsWith(QStringLiteral("“") + name))
        return card;
    return nullptr;
  }
  [[nodiscard]] QString title(const char* name) { return card(name)->findChild<QLabel*>("cardTitle")->text(); }
  void press(Card* card, const char* button)
  {
    QPushButton& found = *card->findChild<QPushButton*>(button);
    test::click(found, QPointF(found.rect().center()));
  }
  [[nodiscard]] Index row(const char* name) const { return indexOf(editor.list(), name).value(); }
  [[nodiscard]] ConstraintStatus status(Index row) const
  {
    return editor.deformation()->report.constraints[row].status;
  }

  const char* lifted = "bolt 1 lifted by 0.5 though it is fixed (conflicting)";
  const char* crown = "crown forward by 3.5 instead (conflicting)";
  const char* flange = "flange 4, 0.75 off the plane of 1 to 3 (conflicting)";
  Editor editor;
  std::unique_ptr<QWidget> conflicts{newConflictPanel(editor)};
  QWidget& panel = *conflicts;
};

TEST_F(ConflictPanelOfBracket, SaysByHowMuchAndWithWhatEachConflicts)
{
  ASSERT_NE(card(lifted), nullptr);
  EXPECT_TRUE(title(lifted).contains("0.5\u00a0mm away from where “bolts front” puts it"))
      << title(lifted).toStdString();
  EXPECT_TRUE(title(crown).contains("2\u00a0mm away from where “crown forward by 1.5” puts it"));
  EXPECT_TRUE(title(flange).contains("“flange 1” and “flange 2” put it")) << title(flange).toStdString();
  EXPECT_TRUE(card(lifted)->findChild<QLabel*>("cardText")->text().contains("(0, 0, 0.5) mm"));
  EXPECT_TRUE(panel.findChild<QLabel*>("repetitions")
                  ->text()
                  .contains("“crown forward by 1.5 once more (redundant)” "
                            "repeats “crown forward by 1.5”"));
}

TEST_F(ConflictPanelOfBracket, SelectsTheSet)
{
  press(card(crown), "conflictSelect");
  EXPECT_EQ(editor.selectedConstraints(), (Rows{row("crown forward by 1.5"), row(crown)}));
}

TEST_F(ConflictPanelOfBracket, DisablingTheNamedOneEndsTheConflict)
{
  const Index k = row(lifted);
  press(card(lifted), "conflictDisable");
  EXPECT_FALSE(editor.list().constraints[k].isEnabled);
  EXPECT_EQ(editor.history().undoName(), std::string("disable ") + lifted);
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_EQ(card(lifted), nullptr);
  EXPECT_NE(card(crown), nullptr) << "the others stay";
}

TEST_F(ConflictPanelOfBracket, TheConsistentTargetEndsTheConflict)
{
  const Index k = row(flange);
  const Vector3 target = editor.deformation()->report.constraints[k].conflictSets.front().consistentTarget.value();
  press(card(flange), "conflictRetarget");
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_EQ(status(k), ConstraintStatus::Redundant);
  for (const ConstraintRow& asked : editor.deformation()->details->system.rows) {
    if (asked.constraint == k) {
      EXPECT_EQ(asked.target, target) << "to the last bit";
    }
  }
}

TEST_F(ConflictPanelOfBracket, ThePreferredOneHoldsAndTheOtherGivesWay)
{
  press(card(crown), "conflictPrefer");
  EXPECT_LT(row(crown), row("crown forward by 1.5"));
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_EQ(status(row(crown)), ConstraintStatus::Met);
  EXPECT_EQ(status(row("crown forward by 1.5")), ConstraintStatus::Conflicting);
  editor.undo();
  EXPECT_GT(row(crown), row("crown forward by 1.5"));
}

TEST_F(ConflictPanelOfBracket, TheAverageIsATargetForAllOfTheSet)
{
  EXPECT_FALSE(card(lifted)->findChild<QPushButton*>("conflictAverage")->isVisible()) << "a region has no target";
  EXPECT_FALSE(card(flange)->findChild<QPushButton*>("conflictAverage")->isVisible()) << "points of other places";
  press(card(crown), "conflictAverage");
  ASSERT_TRUE(test::waitForCurrent(editor));
  EXPECT_EQ(card(crown), nullptr);
  EXPECT_EQ(status(row(crown)), ConstraintStatus::Redundant);
}

TEST_F(ConflictPanelOfBracket, RepairsWaitForTheListThatTheyAreOf)
{
  ASSERT_TRUE(card(crown)->isEnabled());
  editor.edit("switch", withEnabled(editor.list(), {0}, Enabling::Disabled));
  EXPECT_FALSE(card(crown)->isEnabled());
}

TEST_F(ConflictPanelOfBracket, SaysWhyAListCannotBeSolved)
{
  ConstraintList list = editor.list();
  list.constraints.push_back({"beyond", true, PointConstraint{AtVertex{1'000'000}, Move{}}});
  editor.edit("add", list);
  ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Unusable; }));
  Card& error = *panel.findChild<Card*>("conflictError");
  EXPECT_TRUE(error.isVisible());
  EXPECT_TRUE(error.findChild<QLabel*>("cardText")->text().contains("1000000"));
}

TEST(ConflictPanelWithoutConflicts, SaysThatNothingContradicts)
{
  Editor editor;
  const std::unique_ptr<QWidget> panel(newConflictPanel(editor));
  ASSERT_TRUE(test::showAndWait(*panel));
  ASSERT_TRUE(test::openMesh(editor, test::grid(3, 3), {"mm", {{"P", true, PointConstraint{AtVertex{0}, Move{}}}}}));
  EXPECT_TRUE(panel->findChild<QLabel*>("conflictEmpty")->isVisible());
  EXPECT_EQ(panel->findChild<QLabel*>("conflictEmpty")->text(), "No conflicts.");
}

TEST(ConflictPanelWithoutConflicts, ALoneRigidRegionIsNoFault)
{
  Editor editor;
  const std::unique_ptr<QWidget> panel(newConflictPanel(editor));
  ASSERT_TRUE(test::showAndWait(*panel));
  ASSERT_TRUE(test::openMesh(editor, test::grid(3, 3), {"mm", {{"R", true, RigidConstraint{{VertexIds{{0, 1, 4}}}}}}}));
  EXPECT_EQ(panel->findChild<QLabel*>("repetitions")->text(), "“R” holds as it is: nothing moves it");
}

}  // namespace
}  // namespace holdfast
