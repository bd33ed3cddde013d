// The plane of a mirror, as a user moves it.

#include <cmath>

#include <gtest/gtest.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The bar whose left side is the mirror of its right side, which is selected.
class MirrorInWindow : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bar.obj", "bar.mirror.constraints.json");
    view.eye = {120, -200, 90};
    view.target = {0, 0, 50};
    look(view);
    editor().selectConstraints({row});
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] const MirrorConstraint& mirror() { return std::get<MirrorConstraint>(list().constraints[row].what); }

  /// The tip of the plane's arrow: VTK draws it at 0.3 of the diagonal of what the plane is placed around.
  [[nodiscard]] QPointF tipOfArrow()
  {
    const Positions& rest = editor().model()->mesh.positions;
    const Vector3 low = rest.colwise().minCoeff();
    const Vector3 high = rest.colwise().maxCoeff();
    return shownAt((low + high) / 2 + 0.3 * 1.1 * (high - low).norm() * Vector3::UnitX());
  }

  void dragArrow(const QPointF& way)
  {
    const QPointF from = tipOfArrow();
    test::drag(viewport(), {from, from + way / 3, from + way * 2 / 3, from + way});
    ASSERT_TRUE(settle());
  }

  Index row = 1;
  test::PlainView view;
};

TEST_F(MirrorInWindow, TheArrowTurnsThePlaneAndUndoTakesItBack)
{
  const auto before = editor().history().state();
  dragArrow({40, 0});
  EXPECT_GT(std::abs(mirror().normal.y()), 0.05) << "about the vertical, as VTK turns it";
  EXPECT_LT(std::abs(mirror().normal.norm() - 1), 1e-12);
  EXPECT_EQ(editor().history().undoName(), "move the mirror of left and right");
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().history().state(), before);
}

TEST_F(MirrorInWindow, AClickChangesNothing)
{
  const auto before = editor().history().state();
  test::click(viewport(), tipOfArrow());
  EXPECT_EQ(editor().history().state(), before);
}

TEST_F(MirrorInWindow, ThePlaneIsThereOnlyWhileTheMirrorIsSelected)
{
  editor().selectConstraints({});
  ASSERT_TRUE(settle());
  const auto before = editor().history().state();
  dragArrow({0, -40});
  EXPECT_EQ(editor().history().state(), before) << "the drag moved the camera";
}

}  // namespace
}  // namespace holdfast
