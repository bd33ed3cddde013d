#include <gtest/gtest.h>

#include <holdfast/document/history.h>
#include <holdfast/surface/surface_locator.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

DocumentState named(const std::string& name)
{
  return {{name, {}}, {}};
}

std::string nameOf(const History& history)
{
  return history.state()->list.units;
}

TEST(History, UndoAndRedoBringBackTheSameObjects)
{
  History history(named("a"));
  const auto before = history.state();
  history.edit("to b", named("b"));
  const auto after = history.state();

  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.state(), before);
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(history.state(), after);
}

TEST(History, TellsWhatUndoAndRedoWouldDo)
{
  History history(named("a"));
  EXPECT_FALSE(history.canUndo());
  EXPECT_FALSE(history.undo());
  EXPECT_EQ(history.undoName(), "");
  history.edit("to b", named("b"));
  history.edit("to c", named("c"));
  EXPECT_EQ(history.undoName(), "to c");
  EXPECT_FALSE(history.redo());
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.undoName(), "to b");
  EXPECT_EQ(history.redoName(), "to c");
}

TEST(History, AnEditForgetsWhatCouldBeRedone)
{
  History history(named("a"));
  history.edit("to b", named("b"));
  history.undo();
  history.edit("to c", named("c"));
  EXPECT_FALSE(history.canRedo());
  history.undo();
  EXPECT_EQ(nameOf(history), "a");
}

TEST(History, AGestureIsOneEdit)
{
  History history(named("a"));
  history.beginGesture("drag");
  for (const char* step : {"b", "c", "d"}) {
    history.updateGesture(named(step));
    EXPECT_EQ(nameOf(history), step);
  }
  history.endGesture();
  EXPECT_EQ(history.undoName(), "drag");
  history.undo();
  EXPECT_EQ(nameOf(history), "a");
  EXPECT_FALSE(history.canUndo());
  history.redo();
  EXPECT_EQ(nameOf(history), "d");
}

TEST(History, ACancelledGestureLeavesTheObjectThatWasThere)
{
  History history(named("a"));
  history.edit("to b", named("b"));
  history.undo();
  const auto before = history.state();
  history.beginGesture("drag");
  history.updateGesture(named("c"));
  history.cancelGesture();
  EXPECT_EQ(history.state(), before);
  EXPECT_FALSE(history.isInGesture());
  EXPECT_EQ(history.redoName(), "to b") << "a gesture that never was forgets nothing";
}

TEST(History, AGestureThatChangesNothingIsNoEdit)
{
  History history(named("a"));
  history.beginGesture("drag");
  history.endGesture();
  EXPECT_FALSE(history.canUndo());
}

TEST(History, UndoEndsAGestureAndTakesItBack)
{
  History history(named("a"));
  history.beginGesture("drag");
  history.updateGesture(named("b"));
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(nameOf(history), "a");
  EXPECT_EQ(history.redoName(), "drag");
}

TEST(History, KnowsWhetherTheFileHasWhatIsShown)
{
  History history(named("a"));
  EXPECT_TRUE(history.isSaved());
  history.edit("to b", named("b"));
  EXPECT_FALSE(history.isSaved());
  history.markSaved(history.state());
  EXPECT_TRUE(history.isSaved());
  history.undo();
  EXPECT_FALSE(history.isSaved());
  history.redo();
  EXPECT_TRUE(history.isSaved());
  history.beginGesture("drag");
  history.updateGesture(named("c"));
  EXPECT_FALSE(history.isSaved());
}

TEST(History, EditsAsideLeaveASavedDocumentSaved)
{
  History history(named("a"));
  history.edit("look", named("a, looked at"), EditKind::Aside);
  EXPECT_TRUE(history.isSaved());
  history.edit("look", named("a, looked at twice"), EditKind::Aside);
  EXPECT_TRUE(history.isSaved());
  history.beginGesture("drag");
  EXPECT_TRUE(history.isSaved()) << "nothing has moved";
  history.updateGesture(named("b"));
  EXPECT_FALSE(history.isSaved());
  history.cancelGesture();
  history.undo();
  EXPECT_TRUE(history.isSaved());
  EXPECT_TRUE(history.canUndo()) << "they are edits all the same";
}

TEST(History, AnEditBesideThoseAsideIsUnsaved)
{
  History history(named("a"));
  history.edit("look", named("a, looked at"), EditKind::Aside);
  history.edit("to b", named("b"));
  EXPECT_FALSE(history.isSaved());
  history.edit("look", named("b, looked at"), EditKind::Aside);
  EXPECT_FALSE(history.isSaved());
  history.markSaved(history.state());
  history.undo();
  EXPECT_TRUE(history.isSaved()) << "the file has more, and all of it";
  history.undo();
  EXPECT_FALSE(history.isSaved());
}

TEST(History, EditsAsideOfADocumentInNoFileDoNotSaveIt)
{
  History history(named("a"));
  history.markUnsaved();
  history.edit("look", named("a, looked at"), EditKind::Aside);
  EXPECT_FALSE(history.isSaved());
}

TEST(History, ForgetsTheOldestEditsBeyondItsLength)
{
  History history(named("0"));
  for (std::size_t k = 1; k <= kLongestHistory + 5; ++k) history.edit("edit", named(std::to_string(k)));
  std::size_t undone = 0;
  while (history.undo()) ++undone;
  EXPECT_EQ(undone, kLongestHistory);
  EXPECT_EQ(nameOf(history), "5");
}

TEST(History, ADocumentThatIsInNoFileIsUnsavedUntilItIsSaved)
{
  History history(named("rest"));
  history.markUnsaved();
  EXPECT_FALSE(history.isSaved());
  EXPECT_FALSE(history.canUndo()) << "nothing was edited";
  history.markSaved(history.state());
  EXPECT_TRUE(history.isSaved());
}

TEST(Measurements, ThoseAtPlacesThatTheMeshLacksAreLeftOut)
{
  const Mesh mesh = test::grid(1, 1);
  const Triangulation triangulation = triangulate(mesh);
  const SurfaceLocator locator(mesh, triangulation);
  const Measurements all{{AtVertex{3}, AtVertex{4}, AtEdge{0, 1, 0.5}, AtFace{9, {1, 0, 0}}},
                         {{AtVertex{0}, AtVertex{3}}, {AtVertex{0}, AtVertex{99}}}};
  const Measurements kept = onMesh(all, locator);
  ASSERT_EQ(kept.probes.size(), 2u);
  EXPECT_EQ(std::get<AtVertex>(kept.probes[0]).vertex, 3);
  EXPECT_EQ(std::get<AtEdge>(kept.probes[1]).j, 1);
  ASSERT_EQ(kept.rulers.size(), 1u);
  EXPECT_EQ(std::get<AtVertex>(kept.rulers[0][1]).vertex, 3);
}

}  // namespace
}  // namespace holdfast
