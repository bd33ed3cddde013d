// Job 1: a bracket goes to targets that are typed.

#include <array>

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

  struct Typed {
    Vector3 near;  // to the vertex that is held
    std::array<const char*, 3> target;
  };
  const std::array<Typed, 3> points{{{{15, 10, 50}, {"15.300000000000001", "8.6", "50.600000000000023"}},
                                     {{-15, 10, 50}, {"-14.7", "8.300000000000002", "50.2"}},
                                     {{0, 10, 65}, {"0.30000000000000004", "6.9", "66.125"}}}};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& [near, target] = points[k];
    viewport().setFocus();
    // The arrows of the last point, which would take the click.
    editor().selectConstraints({});
    const Index held = nearestVertex(near);
    holdVertex(held);
    const Index row = static_cast<Index>(k) + 1;
    for (int axis = 0; axis < 3; ++axis) typeInto(row, Table::X + axis, target[static_cast<std::size_t>(axis)]);
    ASSERT_TRUE(settle());
    EXPECT_EQ(nowOf(held), Vector3(std::stod(target[0]), std::stod(target[1]), std::stod(target[2]))) << k;
    EXPECT_EQ(shown(row, Table::Status), "met");
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
