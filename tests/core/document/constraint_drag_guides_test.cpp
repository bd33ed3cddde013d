// Drags of what points and selections slide on.

#include <gtest/gtest.h>

#include <holdfast/document/constraint_drag.h>

#include "support/meshes.h"

namespace holdfast {
namespace {

/// A grid of 4 x 4 squares, and one constraint that is dragged.
class DragOfGuide : public testing::Test {
 protected:
  [[nodiscard]] ConstraintDrag drag(decltype(Constraint::what) what)
  {
    list.constraints = {{"free", true, std::move(what)}};
    const Index first = 0;
    return {model, list, {&first, 1}, "list"};
  }
  template <class What>
  [[nodiscard]] static What moved(ConstraintDrag& drag, const Vector3& by)
  {
    return std::get<What>(drag.movedBy({{}, 0, {}, by}).constraints[0].what);
  }

  Model model = makeModel(test::grid(4, 4), "grid");
  ConstraintList list;
};

TEST_F(DragOfGuide, ThePlaneOfASelectionMovesAlongItsNormal)
{
  ConstraintDrag plane = drag(SlideConstraint{{VertexIds{{20, 24}}}, OnPlane{Vector3(0, 5, 0), {0, 2, 0}}});
  ASSERT_FALSE(plane.isEmpty());
  EXPECT_FALSE(plane.canRotate());
  EXPECT_EQ(plane.directions(), RowDirections::along({0, 1, 0}));
  EXPECT_EQ(plane.center(), Vector3(2, 5, 0)) << "over the middle of the selection";
  EXPECT_EQ(plane.axes(model.mesh.positions).col(2), Vector3::UnitY());
  EXPECT_EQ(std::get<OnPlane>(moved<SlideConstraint>(plane, {0, 0.5, 0}).on).point, Vector3(0, 5.5, 0));
}

TEST_F(DragOfGuide, PlanesOfVerticesMoveByTheirOffset)
{
  ConstraintDrag plane = drag(SlideConstraint{{VertexIds{{20, 24}}}, OnPlane{{}, {0, 2, 0}, 0.25}});
  const OnPlane after = std::get<OnPlane>(moved<SlideConstraint>(plane, {7, 0.5, 0}).on);
  EXPECT_FALSE(after.point);
  EXPECT_EQ(after.offset, 0.75);
}

TEST_F(DragOfGuide, ALineMovesAcrossItself)
{
  ConstraintDrag line = drag(SlideConstraint{{VertexIds{{20, 24}}}, OnLine{Vector3(0, 4, 0), {1, 0, 0}}});
  EXPECT_EQ(line.directions(), RowDirections::across({1, 0, 0}));
  EXPECT_EQ(std::get<OnLine>(moved<SlideConstraint>(line, {0, 0, 1}).on).point, Vector3(0, 4, 1));
}

TEST_F(DragOfGuide, APointMovesInTheDirectionsThatItIsHeldIn)
{
  ConstraintDrag point = drag(PointConstraint{AtVertex{24}, Coordinates{{std::nullopt, 4.0, std::nullopt}}});
  EXPECT_EQ(point.directions(), RowDirections::along({0, 1, 0}));
  EXPECT_TRUE(drag(PointConstraint{AtVertex{24}, Target{{4, 4, 1}}}).directions().areAll());
}

TEST_F(DragOfGuide, WhatNobodyHasStatedDoesNotMove)
{
  EXPECT_TRUE(drag(SlideConstraint{{VertexIds{{20, 22, 24}}}, FittedPlane{}}).isEmpty());
  EXPECT_TRUE(drag(SlideConstraint{{VertexIds{{20, 24}}}, OnLine{{}, {1, 0, 0}}}).isEmpty());
  EXPECT_TRUE(drag(SlideConstraint{{VertexIds{{20, 24}}}, OnPlane{{}, {0, 1, 0}}, true}).isEmpty());
  EXPECT_TRUE(drag(PointConstraint{AtVertex{24}, OnMesh{"scan.stl"}}).isEmpty()) << "a scan stays where it is";
}

}  // namespace
}  // namespace holdfast
