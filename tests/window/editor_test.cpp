#include <vector>

#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/window/model/editor.h>

#include "gestures.h"
#include "support/source_tree.h"

namespace holdfast {
namespace {

/// The bracket with its measured points, open and solved.
class EditorOfBracket : public ::testing::Test {
 protected:
  void SetUp() override
  {
    const std::string path = test::dataFolder() + "/bracket.obj";
    NoProgress quiet;
    editor.open(loadMesh(path, quiet), {readConstraints(test::dataFolder() + "/bracket.constraints.json"), {}});
    ASSERT_TRUE(waitForCurrent());
  }

  [[nodiscard]] bool waitForCurrent()
  {
    return test::waitUntil([&] { return editor.solveState() == SolveState::Current; });
  }

  /// The list with the last constraint left out.
  [[nodiscard]] ConstraintList shortened() const
  {
    ConstraintList list = editor.list();
    list.constraints.pop_back();
    return list;
  }

  Editor editor;
};

TEST_F(EditorOfBracket, ShowsWhatItsStateAsksFor)
{
  NoProgress quiet;
  const DeformResult expected = deform(*editor.model(), editor.list(), "bracket", editor.state().options, quiet);
  EXPECT_EQ(editor.positions(), expected.positions);
  EXPECT_EQ(&editor.positions(), &editor.deformation()->positions) << "what is picked is what was solved, not a copy";
}

TEST_F(EditorOfBracket, UndoAndRedoBringBackPositionsBitForBit)
{
  const Positions before = editor.positions();
  editor.edit("delete", shortened());
  EXPECT_EQ(editor.solveState(), SolveState::Solving);
  ASSERT_TRUE(waitForCurrent());
  const Positions after = editor.positions();
  EXPECT_NE(before, after);

  editor.undo();
  ASSERT_TRUE(waitForCurrent());
  EXPECT_EQ(editor.positions(), before);
  editor.redo();
  ASSERT_TRUE(waitForCurrent());
  EXPECT_EQ(editor.positions(), after);
}

TEST_F(EditorOfBracket, ACancelledGestureLeavesNothingBehind)
{
  const auto before = editor.history().state();
  const Positions positions = editor.positions();
  editor.beginGesture("drag");
  editor.updateGesture(shortened());
  ASSERT_TRUE(waitForCurrent());
  EXPECT_NE(editor.positions(), positions);
  editor.cancelGesture();
  EXPECT_EQ(editor.history().state(), before);
  EXPECT_EQ(editor.positions(), positions) << "at once, not after another solution";
  EXPECT_FALSE(editor.history().canUndo());
}

TEST_F(EditorOfBracket, SaysWhyAStateCannotBeSolvedAndKeepsWhatWasShown)
{
  const Positions before = editor.positions();
  ConstraintList list = editor.list();
  list.constraints.push_back({"beyond", true, PointConstraint{AtVertex{1'000'000}, Move{}}});
  editor.edit("add", list);
  ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Unusable; }));
  EXPECT_TRUE(editor.error().contains("1000000")) << editor.error().toStdString();
  EXPECT_EQ(editor.positions(), before);
}

TEST_F(EditorOfBracket, MarksAreThoseOfWhatIsShown)
{
  const auto before = editor.marks();
  const auto stateBefore = editor.deformedState();
  const auto disabled = [this] {
    std::vector<Index> constraints;
    for (const ConstraintMark& mark : editor.marks()->marks)
      if (mark.status == ConstraintStatus::Disabled) constraints.push_back(mark.constraint);
    return constraints;
  };
  ASSERT_TRUE(disabled().empty());

  ConstraintList list = editor.list();
  const Index last = static_cast<Index>(list.constraints.size()) - 1;
  list.constraints.back().isEnabled = false;
  list.constraints.push_back({"beyond", true, PointConstraint{AtVertex{1'000'000}, Move{}}});
  editor.edit("disable and add", list);
  ASSERT_TRUE(test::waitUntil([&] { return editor.solveState() == SolveState::Unusable; }));
  EXPECT_EQ(editor.marks(), before);
  EXPECT_EQ(editor.deformedState(), stateBefore);

  list.constraints.pop_back();
  editor.edit("delete", list);
  ASSERT_TRUE(waitForCurrent());
  EXPECT_EQ(disabled(), (std::vector<Index>{last}));
}

TEST_F(EditorOfBracket, CancelledWorkSaysSoAndCanBeTakenUpAgain)
{
  editor.edit("delete", shortened());
  editor.cancelSolving();
  EXPECT_EQ(editor.solveState(), SolveState::Cancelled);
  editor.solve();
  EXPECT_TRUE(waitForCurrent());
}

TEST_F(EditorOfBracket, AnotherDocumentBeginsAnew)
{
  editor.selectVertices({3, 1, 3});
  EXPECT_EQ(editor.selectedVertices(), (std::vector<Index>{1, 3}));
  editor.edit("delete", shortened());
  SetUp();
  EXPECT_FALSE(editor.history().canUndo());
  EXPECT_TRUE(editor.selectedVertices().empty());
}

}  // namespace
}  // namespace holdfast
