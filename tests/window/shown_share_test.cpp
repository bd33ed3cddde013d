// The shape at rest, the deformed one and all between.

#include <QAction>
#include <QSlider>

#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

class ShownShareInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    viewport().setFocus();
  }

  [[nodiscard]] const Positions& rest() { return editor().model()->mesh.positions; }

  /// What is drawn and picked.
  void expectShown(const Positions& expected)
  {
    ASSERT_TRUE(settle());
    EXPECT_EQ(viewport().surface()->positions(), expected);
    MeshActor& mesh = viewport().contents()->mesh();
    for (std::size_t point = 0; point < mesh.vertexOf().size(); ++point) {
      const Vector3 drawn(mesh.points().GetPoint(static_cast<vtkIdType>(point)));
      ASSERT_EQ(drawn, Vector3(expected.row(mesh.vertexOf()[point])));
    }
  }
};

TEST_F(ShownShareInWindow, AKeyShowsRestAndDeformationInTurn)
{
  const Positions deformed = editor().positions();
  ASSERT_NE(deformed, rest());
  const auto state = editor().history().state();
  const auto marks = viewport().marks();
  for (int k = 0; k < 2; ++k) {
    key(Qt::Key_O);
    expectShown(rest());
    EXPECT_TRUE(find<QAction>("showRest").isChecked());
    EXPECT_EQ(find<QSlider>("shownShare").value(), 0);
    ASSERT_EQ(viewport().marks().size(), marks.size());
    for (std::size_t m = 0; m < marks.size(); ++m) EXPECT_EQ(viewport().marks()[m].place, marks[m].rest);
    key(Qt::Key_O);
    expectShown(deformed);
    EXPECT_EQ(viewport().marks()[0].place, marks[0].place);
  }
  EXPECT_EQ(editor().history().state(), state);
}

TEST_F(ShownShareInWindow, TheSliderShowsAllBetween)
{
  const Positions deformed = editor().positions();
  openPanel("Colours");
  auto& slider = find<QSlider>("shownShare");
  slider.setFocus();
  for (int k = 0; k < 3; ++k) key(Qt::Key_PageDown);
  for (int k = 0; k < 5; ++k) key(Qt::Key_Left);
  ASSERT_EQ(slider.value(), 65);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(viewport().surface()->positions().isApprox(0.35 * rest() + 0.65 * deformed, 1e-12));
  EXPECT_FALSE(find<QAction>("showRest").isChecked());
  key(Qt::Key_End);
  expectShown(deformed);
  for (int k = 0; k < 10; ++k) key(Qt::Key_PageDown);
  ASSERT_EQ(slider.value(), 0);
  expectShown(rest());
}

TEST_F(ShownShareInWindow, AnEditIsShownInFull)
{
  key(Qt::Key_O);
  expectShown(rest());
  editor().selectConstraints({*indexOf(list(), "flange east")});
  key(Qt::Key_E);
  ASSERT_TRUE(settle());
  EXPECT_EQ(viewport().shownShare(), 1);
  EXPECT_EQ(find<QSlider>("shownShare").value(), 100);
  expectShown(editor().positions());
  key(Qt::Key_O);
  open("bar.obj");
  EXPECT_EQ(viewport().shownShare(), 1);
  EXPECT_FALSE(find<QAction>("showRest").isChecked());
}

}  // namespace
}  // namespace holdfast
