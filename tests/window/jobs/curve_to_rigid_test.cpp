// Job 4: a curve around a feature, which keeps its shape while the surface moves.

#include <gtest/gtest.h>

#include "window/gestures.h"
#include "window/jobs/job_window.h"

namespace holdfast {
namespace {

using CurveJob = test::JobWindow;

TEST_F(CurveJob, AFeatureInsideACurveKeepsItsShape)
{
  openFile(sample("head.ply"));
  key(Qt::Key_1, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  const QPointF neck = seenAt(nearestVertex({0, -12.6, -99}));
  static_cast<void>(constrainBy(Qt::Key_B, {neck, neck + QPointF(30, -4)}, Qt::Key_F));

  key(Qt::Key_C);
  for (const Vector3& place : {Vector3(43, -76, 25), Vector3(27, -76, 41), Vector3(11, -76, 25), Vector3(27, -76, 9)})
    test::click(viewport(), seenAt(nearestVertex(place)));
  key(Qt::Key_Return);
  const std::vector<Index> eye = editor().selectedVertices();
  ASSERT_GT(eye.size(), 20u);
  key(Qt::Key_R);
  ASSERT_TRUE(settle());
  ASSERT_EQ(list().constraints.size(), 2u);
  const auto& rigid = std::get<RigidConstraint>(list().constraints[1].what);
  ASSERT_TRUE(std::holds_alternative<InsideCurve>(rigid.select.what)) << "the curve is kept, not its vertices";

  // The nose is pulled, and turns what is around it.
  const Index nose = nearestVertex({0, -120, 0});
  holdVertex(nose);
  viewport().setFocus();
  keys("y25-");
  key(Qt::Key_Return);
  ASSERT_TRUE(settle());
  EXPECT_EQ(nowOf(nose).y(), restOf(nose).y() - 25);

  double farthest = 0;
  for (const Index v : eye) {
    farthest = std::max(farthest, (nowOf(v) - restOf(v)).norm());
    for (const Index w : eye)
      ASSERT_NEAR((nowOf(v) - nowOf(w)).norm(), (restOf(v) - restOf(w)).norm(), 1e-9) << v << ", " << w;
  }
  EXPECT_GT(farthest, 0.5) << "it has moved";
  expectAllMet();
  expectPicture();
}

}  // namespace
}  // namespace holdfast
