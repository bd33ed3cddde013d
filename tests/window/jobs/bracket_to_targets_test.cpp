// Job 1: a bracket goes to targets that are typed.

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
  // The top of the base stays.
  key(Qt::Key_W);
  test::click(viewport(), seenAt(nearestVertex({50, 0, 12})));
  ASSERT_GT(editor().selectedVertices().size(), 100u);
  key(Qt::Key_F);
  ASSERT_TRUE(settle());

  const std::array<std::array<const char*, 3>, 3> typed{{{"1.0000000000000002", "-0.30000000000000004", "81.25"},
                                                         {"-20.1", "11.7", "61.900000000000006"},
                                                         {"21.3", "-3.3333333333333335", "44.4"}}};
  std::array<Index, 3> held{};
  for (std::size_t k = 0; k < typed.size(); ++k) {
    viewport().setFocus();
    held[k] = freeVertex();
    holdVertex(held[k]);
    for (int axis = 0; axis < 3; ++axis)
      typeInto(static_cast<Index>(k) + 1, Table::X + axis, typed[k][static_cast<std::size_t>(axis)]);
    ASSERT_TRUE(settle());
  }
  for (std::size_t k = 0; k < typed.size(); ++k) {
    const Vector3 place(std::stod(typed[k][0]), std::stod(typed[k][1]), std::stod(typed[k][2]));
    EXPECT_EQ(nowOf(held[k]), place) << k;
    EXPECT_EQ(shown(static_cast<Index>(k) + 1, Table::Status), "met");
  }
  for (const Index v : verticesOf(0)) ASSERT_EQ(nowOf(v), restOf(v)) << v;

  // By exactly 2.5 along x: the glyph, the arrow, the number.
  viewport().setFocus();
  key(Qt::Key_S);
  key(Qt::Key_Escape);
  test::click(viewport(), seenAt(held[0]));
  ASSERT_EQ(editor().selectedConstraints(), std::vector<Index>{1});
  const Vector3 before = targetOf(1);
  keys("x2.5");
  key(Qt::Key_Return);
  ASSERT_TRUE(settle());
  EXPECT_EQ(targetOf(1), Vector3(before.x() + 2.5, before.y(), before.z()));
  EXPECT_EQ(nowOf(held[0]), targetOf(1));
  expectAllMet();
  expectPicture();
}

}  // namespace
}  // namespace holdfast
