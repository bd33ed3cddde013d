#include <QApplication>
#include <QLabel>
#include <QPushButton>

#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/window/controls/panel_parts.h>
#include <holdfast/window/model/constraint_actions.h>
#include <holdfast/window/panels/panels.h>
#include <holdfast/window/text/constraint_text.h>

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

/// A sheet whose corners are held, and points of one place in its middle that go to different places.
class PointsOfOnePlace : public ::testing::Test {
 protected:
  void SetUp() override
  {
    panel.resize(520, 700);
    ASSERT_TRUE(test::showAndWait(panel));
  }

  /// Points at vertex 12 that go up by these lengths.
  [[nodiscard]] static ConstraintList pointsUp(const std::vector<double>& heights)
  {
    ConstraintList list{"mm", {{"corners", true, FixedConstraint{{VertexIds{{0, 4, 20, 24}}}}}}};
    for (const double height : heights)
      list.constraints.push_back({"P" + std::to_string(list.constraints.size()), true,
                                  PointConstraint{AtVertex{12}, Move{Vector3(0, 0, height)}}});
    return list;
  }

  [[nodiscard]] bool open(const ConstraintList& list) { return test::openMesh(editor, test::grid(4, 4), list); }

  [[nodiscard]] std::vector<QPushButton*> buttons(const char* name)
  {
    std::vector<QPushButton*> all;
    for (QPushButton* button : panel.findChildren<QPushButton*>(name))
      if (button->isVisible()) all.push_back(button);
    return all;
  }

  /// Presses the button of the first card until there is no card any more; how often that took.
  [[nodiscard]] int averagesToTheEnd()
  {
    int presses = 0;
    for (; !buttons("conflictAverage").empty() && presses < 20; ++presses) {
      QPushButton& button = *buttons("conflictAverage").front();
      test::click(button, QPointF(button.rect().center()));
      EXPECT_TRUE(test::waitForCurrent(editor));
      QApplication::processEvents();
    }
    EXPECT_TRUE(buttons("conflictDisable").empty());
    return presses;
  }

  [[nodiscard]] double heightOf(Index vertex) const { return editor.positions()(vertex, 2); }

  Editor editor;
  std::unique_ptr<QWidget> conflicts{newConflictPanel(editor)};
  QWidget& panel = *conflicts;
};

TEST_F(PointsOfOnePlace, AgreeOnOneMeanAtOnce)
{
  for (const std::vector<double>& heights :
       {std::vector<double>{1, 2}, {1, 2, 6}, {0.5, 0.25, 4, 8}, {1, 1, 4}, {4, 1, 1}, {2, -1, 5, 2, 2}}) {
    ASSERT_TRUE(open(pointsUp(heights)));
    ASSERT_FALSE(buttons("conflictAverage").empty());
    EXPECT_EQ(averagesToTheEnd(), 1);
    double sum = 0;
    for (const double height : heights) sum += height / static_cast<double>(heights.size());
    EXPECT_NEAR(heightOf(12), sum, 1e-14);
    EXPECT_EQ(editor.history().undoName().find("give"), 0u);
    editor.undo();
    ASSERT_TRUE(test::waitForCurrent(editor));
    EXPECT_FALSE(buttons("conflictAverage").empty()) << "one edit";
  }
}

TEST_F(PointsOfOnePlace, AreOneSetOnEveryCard)
{
  ASSERT_TRUE(open(pointsUp({1, 2, 6})));
  const auto averages = buttons("conflictAverage");
  ASSERT_EQ(averages.size(), 2u) << "each of the later two is at odds with the first";
  EXPECT_EQ(averages[0]->text(), "Use the average (2, 2, 3)");
  EXPECT_EQ(averages[1]->text(), averages[0]->text());
  QPushButton& select = *buttons("conflictSelect").front();
  test::click(select, QPointF(select.rect().center()));
  EXPECT_EQ(editor.selectedConstraints(), (Rows{1, 2, 3}));
}

TEST_F(PointsOfOnePlace, ThatAreDisabledKeepTheirTargets)
{
  ConstraintList list = pointsUp({1, 2, 6});
  list.constraints[3].isEnabled = false;
  ASSERT_TRUE(open(list));
  EXPECT_EQ(averagesToTheEnd(), 1);
  EXPECT_NEAR(heightOf(12), 1.5, 1e-14);
  EXPECT_EQ(std::get<Move>(std::get<PointConstraint>(editor.list().constraints[3].what).to).shift.z(), 6);
}

TEST_F(PointsOfOnePlace, HaveNamesThatDifferOnTheButtons)
{
  ConstraintList list = pointsUp({});
  const char* const names[] = {"measured point 1 of the left flange", "measured point 2 of the left flange",
                               "crown of the right flange"};
  for (Index k = 0; k < 3; ++k) {
    list.constraints.push_back({"A" + std::to_string(k), true, PointConstraint{AtVertex{11 + k}, Move{}}});
    list.constraints.push_back({names[k], true, PointConstraint{AtVertex{11 + k}, Move{Vector3(0, 0, 1)}}});
  }
  ASSERT_TRUE(open(list));
  QStringList texts;
  for (const QPushButton* button : buttons("conflictDisable")) texts << button->text();
  ASSERT_EQ(texts.size(), 3);
  EXPECT_NE(texts[0], texts[1]);
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE(texts[k].startsWith("Disable “measured")) << texts[k].toStdString();
    EXPECT_TRUE(texts[k].endsWith("left flange”")) << texts[k].toStdString();
  }
  EXPECT_EQ(texts[2], "Disable “crown of… flange”") << "as short as others where that is enough";
}

TEST(NamesOnButtons, AreCutInTheMiddleAndDiffer)
{
  const auto cut = [](const char* name, const std::vector<std::string>& others) {
    return quotedEnds(name, others, 16).toStdString();
  };
  EXPECT_EQ(cut("sixteen letters.", {}), "“sixteen letters.”");
  EXPECT_EQ(cut("more than sixteen letters", {}), "“more tha…letters”");
  EXPECT_EQ(cut("0001 measured point", {"0002 measured point"}), "“0001 mea…d point”");
  EXPECT_EQ(cut("measured point 0001", {"measured point 0002"}), "“measured…nt 0001”");
  EXPECT_NE(cut("measured point 1 of the flange", {"measured point 2 of the flange"}),
            cut("measured point 2 of the flange", {"measured point 1 of the flange"}));
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
