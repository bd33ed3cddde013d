// Job 1: a bracket goes to targets that are typed.

#include <QByteArray>

#include <gtest/gtest.h>

#include <holdfast/window/table/constraint_table_model.h>

#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;

class BracketJob : public test::JobWindow {
 protected:
  [[nodiscard]] Vector3 targetOf(Index constraint)
  {
    return std::get<Target>(std::get<PointConstraint>(list().constraints[constraint].what).to).place;
  }
};

TEST_F(BracketJob, GoesToTypedTargetsBitForBit)
{
  openFile(sample("bracket.obj"));
  // The top of the base stays: what is in the plane that is clicked.
  key(Qt::Key_W);
  key(Qt::Key_N);
  for (int k = 0; k < 4; ++k) key(Qt::Key_BracketLeft);
  test::click(viewport(), seenAt(nearestVertex({35, -25, 12})));
  ASSERT_GT(editor().selectedVertices().size(), 100u);
  for (const Index v : editor().selectedVertices()) ASSERT_EQ(restOf(v).z(), 12) << v;
  key(Qt::Key_F);
  ASSERT_TRUE(settle());

  for (Index k = 0; k < 3; ++k) {
    viewport().setFocus();
    // The arrows of the last point would take the click.
    editor().selectConstraints({});
    const Index held = freeVertex();
    const Vector3 target = nowOf(held) + Vector3(0.1, -0.3, 0.7) * (k + 1) / 3;
    holdVertex(held);
    for (int axis = 0; axis < 3; ++axis)
      typeInto(k + 1, Table::X + axis, QByteArray::number(target[axis], 'g', 17).constData());
    ASSERT_TRUE(settle());
    EXPECT_EQ(nowOf(held), target) << k;
    EXPECT_EQ(shown(k + 1, Table::Status), "met");
  }
  for (const Index v : verticesOf(0)) ASSERT_EQ(nowOf(v), restOf(v)) << v;

  // By exactly 2.5 along x: the glyph, the arrow, the number.
  viewport().setFocus();
  key(Qt::Key_S);
  key(Qt::Key_Escape);
  const Index moved = std::get<AtVertex>(std::get<PointConstraint>(list().constraints[1].what).at).vertex;
  test::click(viewport(), seenAt(moved));
  ASSERT_EQ(editor().selectedConstraints(), std::vector<Index>{1});
  const Vector3 before = targetOf(1);
  keys("x2.5");
  key(Qt::Key_Return);
  ASSERT_TRUE(settle());
  EXPECT_EQ(targetOf(1), Vector3(before.x() + 2.5, before.y(), before.z()));
  EXPECT_EQ(nowOf(moved), targetOf(1));
  expectAllMet();
  expectPicture();
}

}  // namespace
}  // namespace holdfast
