#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/document/constraint_drag.h>
#include <holdfast/document/history.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/law_meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

constexpr double kLength = 6;

/// A bar that stands on its fixed end. The other end is a handle that turns about what is fixed.
class DragAboutFixed : public testing::Test {
 protected:
  const Model model = makeModel(test::quadBox({1, 1, kLength}, 4), "bar");
  ConstraintList list = barList();
  ConstraintDrag drag = dragOf(list);

  [[nodiscard]] static ConstraintList barList()
  {
    const auto below = [](const Vector3& point, const Vector3& normal) {
      return Selection{InHalfSpace{point, normal}};
    };
    return {"",
            {{"base", true, FixedConstraint{below({0, 0, 0.1}, {0, 0, -1})}},
             {"top", true,
              HandleConstraint{below({0, 0, kLength - 0.1}, {0, 0, 1}), RotationAboutFixed{}, {0, 0, 0}, {}}}}};
  }

  [[nodiscard]] ConstraintDrag dragOf(const ConstraintList& start) const
  {
    const Index top = 1;
    return {model, start, {&top, 1}, "list"};
  }

  /// Returns where the handle is after `degrees` of the circle about the fixed end, which begins at the top.
  [[nodiscard]] static Vector3 onCircle(double degrees)
  {
    if (std::remainder(degrees, 360) == 180) return {0, 0, -2 * kLength};  // exactly opposite
    const double angle = degrees * kDegree;
    return kLength * Vector3(std::sin(angle), 0, std::cos(angle) - 1);
  }

  [[nodiscard]] ConstraintList frame(const Vector3& translation) { return drag.movedBy({{}, 0, {}, translation}); }

  [[nodiscard]] DeformResult deformed(const ConstraintList& of)
  {
    NoProgress progress;
    return deformer_.deform(of, "list", progress);
  }

  [[nodiscard]] Vector3 turnOfTop(const DeformResult& deformation) const
  {
    return deformation.details->system.rotations.back().q;
  }

  [[nodiscard]] static const HandleConstraint& top(const ConstraintList& of)
  {
    return std::get<HandleConstraint>(of.constraints[1].what);
  }

 private:
  Deformer deformer_{model, {}};
};

TEST_F(DragAboutFixed, SaysWhereTheHandleIsToBeBeforeAnythingIsSolved)
{
  const ConstraintList moved = frame(onCircle(70));
  const Positions places = drag.handlePlaces(moved);
  const std::vector<Index> vertices = drag.handleVertices();
  ASSERT_EQ(places.rows(), static_cast<Index>(vertices.size()));
  ASSERT_GT(places.rows(), 4);
  EXPECT_EQ(Positions(deformed(moved).positions(vertices, Eigen::all)), places);
}

TEST_F(DragAboutFixed, GoesRoundAndRoundWithoutAJump)
{
  constexpr double kStep = 2;
  Positions before = deformed(list).positions;
  for (double degrees = kStep; degrees <= 800; degrees += kStep) {
    const DeformResult now = deformed(frame(onCircle(degrees)));
    EXPECT_LT((turnOfTop(now) - Vector3(0, degrees / 360 * std::numbers::pi, 0)).norm(), 1e-9) << degrees;
    // The end moves by 0.21 each time, what lies between by no more than a few times that.
    EXPECT_LT((now.positions - before).rowwise().norm().maxCoeff(), 0.5) << degrees;
    before = now.positions;
  }
}

TEST_F(DragAboutFixed, GoesBackTheSameWay)
{
  for (const double degrees : {90, 170, 180, 250, 340, 400, 340, 250, 180, 170, 90}) {
    const Vector3 q = turnOfTop(deformed(frame(onCircle(degrees))));
    EXPECT_LT((q - Vector3(0, degrees / 360 * std::numbers::pi, 0)).norm(), 1e-9) << degrees;
  }
  const ConstraintList back = frame(onCircle(0));
  EXPECT_EQ(constraintsToJson(back), constraintsToJson(list)) << "no motion is the list that there was";
}

TEST_F(DragAboutFixed, SaysTheTurnFromHalfATurnOnOnly)
{
  EXPECT_FALSE(std::get<RotationAboutFixed>(top(frame(onCircle(100))).motion).near.has_value());
  EXPECT_FALSE(std::get<RotationAboutFixed>(top(frame(onCircle(179))).motion).near.has_value());
  EXPECT_TRUE(std::get<RotationAboutFixed>(top(frame(onCircle(180))).motion).near.has_value());
  const auto near = std::get<RotationAboutFixed>(top(frame(onCircle(181))).motion).near;
  ASSERT_TRUE(near.has_value());
  EXPECT_NEAR(near->degrees, 181, 1e-9);
  EXPECT_FALSE(std::get<RotationAboutFixed>(top(frame(onCircle(100))).motion).near.has_value());
}

TEST_F(DragAboutFixed, IsTheSameBitForBitWhenItHasBeenWrittenAndRead)
{
  for (double degrees = 0; degrees <= 760; degrees += 20) {
    const ConstraintList now = frame(onCircle(degrees));
    const ConstraintList read = parseConstraintsJson(constraintsToJson(now), "list");
    const DeformResult shown = deformed(now);
    const DeformResult again = deformed(read);
    EXPECT_EQ(again.positions, shown.positions) << degrees;
    EXPECT_EQ(again.rotations, shown.rotations) << degrees;
  }
}

TEST_F(DragAboutFixed, GoesOnWhereTheLastDragEnded)
{
  for (const double degrees : {100, 190, 280}) static_cast<void>(frame(onCircle(degrees)));
  const ConstraintList kept = frame(onCircle(350));
  ConstraintDrag next = dragOf(kept);
  EXPECT_EQ(constraintsToJson(next.movedBy({})), constraintsToJson(kept)) << "no motion is the list that there was";
  const DeformResult on = deformed(next.movedBy({{}, 0, {}, onCircle(370) - onCircle(350)}));
  EXPECT_LT((turnOfTop(on) - Vector3(0, 370.0 / 360 * std::numbers::pi, 0)).norm(), 1e-9);
}

TEST_F(DragAboutFixed, IsOneEditAndIsTakenBackAsOne)
{
  History history({list, {}});
  const auto before = history.state();
  const auto goRound = [&] {
    drag = dragOf(history.state()->list);
    history.beginGesture("move top");
    for (double degrees = 0; degrees <= 400; degrees += 20) history.updateGesture({frame(onCircle(degrees)), {}});
  };
  goRound();
  history.cancelGesture();
  EXPECT_EQ(history.state(), before);
  EXPECT_FALSE(history.canUndo());
  goRound();
  history.endGesture();
  const Vector3 q = turnOfTop(deformed(history.state()->list));
  EXPECT_LT((q - Vector3(0, 400.0 / 360 * std::numbers::pi, 0)).norm(), 1e-9) << "the first time left nothing behind";
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.state(), before);
  EXPECT_FALSE(history.canUndo());
}

TEST_F(DragAboutFixed, PassesOverWhatHasNoDirectionAndGoesOn)
{
  static_cast<void>(frame(onCircle(150)));
  const ConstraintList astray = frame({0, 0, -kLength});
  EXPECT_THROW(static_cast<void>(deformed(astray)), InputError) << "it lies at the centroid of what is fixed";
  const Vector3 q = turnOfTop(deformed(frame(onCircle(210))));
  EXPECT_LT((q - Vector3(0, 210.0 / 360 * std::numbers::pi, 0)).norm(), 1e-9);
}

TEST_F(DragAboutFixed, TurnedByARingItKeepsWhatItHasTurned)
{
  for (const double degrees : {100, 190, 280}) static_cast<void>(frame(onCircle(degrees)));
  ConstraintDrag ring = dragOf(frame(onCircle(280)));
  const ConstraintList rotated = ring.movedBy({{0, 1, 0}, 30, ring.center(), {0, 0, 0}});
  EXPECT_NEAR(std::get<AxisRotation>(top(rotated).motion).degrees, 310, 1e-9);
}

TEST(DragOfPoints, RotatesThemAsAGroup)
{
  const Model model = makeModel(test::quadBox({1, 1, 1}, 1), "box");
  const ConstraintList list{"",
                            {{"A", true, PointConstraint{AtVertex{0}, Target{Vector3(1, 0, 0)}}},
                             {"B", true, PointConstraint{AtVertex{1}, Move{Vector3::Zero()}}},
                             {"C", true, PointConstraint{AtVertex{2}, Target{Vector3(-1, 0, 0)}}}}};
  const std::vector<Index> ends{0, 2};
  ConstraintDrag drag(model, list, ends, "list");
  EXPECT_TRUE(drag.canRotate());
  EXPECT_EQ(drag.center(), Vector3(0, 0, 0));
  const ConstraintList rotated = drag.movedBy({Vector3::UnitZ(), 90, drag.center(), Vector3::Zero()});
  const auto target = [&](Index k) {
    return std::get<Target>(std::get<PointConstraint>(rotated.constraints[k].what).to).place;
  };
  EXPECT_LT((target(0) - Vector3(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((target(2) - Vector3(0, -1, 0)).norm(), 1e-15);
  const Index one = 0;
  EXPECT_FALSE(ConstraintDrag(model, list, {&one, 1}, "list").canRotate()) << "a point alone has nothing to rotate";
}

/// Which of four points and a region of a box share a place, and where they go on average.
class SharedPlaceOfBox : public ::testing::Test {
 protected:
  [[nodiscard]] std::optional<SharedPlace> of(const std::vector<Index>& constraints) const
  {
    return sharedPlace(makeConstraintSystem(list, model.mesh, model.solverMesh, model.locator(), "list"), constraints);
  }

  const Model model = makeModel(test::quadBox({1, 1, 1}, 1), "box");
  const Vector3 rest = model.mesh.positions.row(0);
  ConstraintList list{"",
                      {{"A", true, PointConstraint{AtVertex{0}, Target{Vector3(1, 2, 3)}}},
                       {"B", true, PointConstraint{AtNear{rest}, Move{Vector3(1, 0, 0)}}},
                       {"C", true, PointConstraint{AtVertex{1}, Move{}}},
                       {"D", true, FixedConstraint{{VertexIds{{0}}}}},
                       {"E", true, PointConstraint{AtVertex{0}, Move{Vector3(0, 0, 6)}}}}};
};

TEST_F(SharedPlaceOfBox, IsOneOfAllPointsThatAreThere)
{
  for (const std::vector<Index>& some : {std::vector<Index>{0, 1}, {4, 0}, {1, 4}, {0, 1, 4}}) {
    ASSERT_TRUE(of(some));
    EXPECT_EQ(of(some)->constraints, (std::vector<Index>{0, 1, 4}));
    EXPECT_EQ(of(some)->mean, Vector3((Vector3(1, 2, 3) + (rest + Vector3(1, 0, 0)) + (rest + Vector3(0, 0, 6))) / 3));
  }
}

TEST_F(SharedPlaceOfBox, LeavesOutThoseThatAreDisabled)
{
  list.constraints[4].isEnabled = false;
  EXPECT_EQ(of({0, 1})->constraints, (std::vector<Index>{0, 1}));
  EXPECT_EQ(of({0, 1})->mean, Vector3((Vector3(1, 2, 3) + rest + Vector3(1, 0, 0)) / 2));
  EXPECT_FALSE(of({0, 4}));
}

TEST_F(SharedPlaceOfBox, IsThatOfPointsOfOnePlaceOnly)
{
  EXPECT_FALSE(of({0})) << "one agrees with itself";
  EXPECT_FALSE(of({0, 2})) << "points of two places";
  EXPECT_FALSE(of({0, 3})) << "a region has no target";
  EXPECT_FALSE(of({3, 0}));
}

TEST(SharedPlace, HasTheCopiesOfACorner)
{
  // Two triangles on one side, each with corners of its own.
  Mesh pair{Positions(6, 3), {}};
  pair.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  pair.faces.add({0, 1, 2});
  pair.faces.add({3, 4, 5});
  const Model model = makeModel(pair, "pair");
  const ConstraintList list{"",
                            {{"A", true, PointConstraint{AtVertex{1}, Move{Vector3(2, 0, 0)}}},
                             {"B", true, PointConstraint{AtVertex{3}, Move{Vector3(0, 4, 0)}}}}};
  const auto system = makeConstraintSystem(list, model.mesh, model.solverMesh, model.locator(), "list");
  const auto shared = sharedPlace(system, std::vector<Index>{0, 1});
  ASSERT_TRUE(shared);
  EXPECT_EQ(shared->mean, Vector3(2, 2, 0));
}

}  // namespace
}  // namespace holdfast
