#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/widgets/marks/constraint_guides.h>

#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using Lines = std::vector<std::array<Vector3, 2>>;

/// A grid of 4 x 4 squares with one side held, and one more constraint.
class GuidesOfOne : public testing::Test {
 protected:
  std::vector<ConstraintGuide> guidesOf(decltype(Constraint::what) what)
  {
    const ConstraintList list{
        "", {{"hold", true, FixedConstraint{{VertexIds{{0, 1, 2, 3, 4}}}}}, {"free", true, std::move(what)}}};
    NoProgress progress;
    deformation = deform(model, list, "constraints", {}, progress);
    std::vector<ConstraintGuide> guides = constraintGuides(model, deformation);
    for (const ConstraintGuide& guide : guides) {
      EXPECT_EQ(guide.constraint, 1) << "what is held in all directions has none";
      EXPECT_EQ(guide.status, ConstraintStatus::Met);
    }
    return guides;
  }

  [[nodiscard]] static double farthest(const Lines& lines, const Vector3& from)
  {
    double most = 0;
    for (const auto& line : lines)
      for (const Vector3& end : line) most = std::max(most, (end - from).norm());
    return most;
  }

  Model model = makeModel(test::grid(4, 4), "grid");
  DeformResult deformation;
};

TEST_F(GuidesOfOne, APointOnAPlaneHasASquareInIt)
{
  const Vector3 normal = Vector3(1, 0, 2).normalized();
  const auto guides = guidesOf(PointConstraint{AtVertex{24}, OnPlane{Vector3(4, 4, 0.5), {1, 0, 2}}});
  ASSERT_EQ(guides.size(), 1);
  EXPECT_EQ(guides[0].shape, GuideShape::Plane);
  for (const Vector3& corner : cornersOf(guides[0])) {
    EXPECT_NEAR(normal.dot(corner - Vector3(4, 4, 0.5)), 0, 1e-12);
    EXPECT_LT((corner - Vector3(4, 4, 0.5)).norm(), 1);
  }
  EXPECT_EQ(outlineOf(guides[0]).size(), 4);
}

TEST_F(GuidesOfOne, AFreeCoordinateIsALineAndTwoAreASquare)
{
  const auto line = guidesOf(PointConstraint{AtVertex{24}, Coordinates{{4.5, std::nullopt, 0.5}}});
  ASSERT_EQ(line.size(), 1);
  EXPECT_EQ(line[0].shape, GuideShape::Line);
  const auto [from, to] = outlineOf(line[0]).front();
  EXPECT_EQ((to - from).normalized().cwiseAbs(), Vector3::UnitY());
  const auto square = guidesOf(PointConstraint{AtVertex{24}, Coordinates{{std::nullopt, std::nullopt, 0.5}}});
  ASSERT_EQ(square.size(), 1);
  EXPECT_EQ(square[0].shape, GuideShape::Plane);
}

TEST_F(GuidesOfOne, ASelectionSharesItsPlaneAsLargeAsItIs)
{
  const auto guides = guidesOf(SlideConstraint{{VertexIds{{20, 22, 24}}}, OnPlane{Vector3(0, 4, 0), {0, 1, 0}}});
  ASSERT_EQ(guides.size(), 1);
  Eigen::AlignedBox3d box;
  for (const Vector3& corner : cornersOf(guides[0])) box.extend(corner);
  EXPECT_LE(box.min().x(), 0);
  EXPECT_GE(box.max().x(), 4);
  EXPECT_LT(box.sizes().x(), 5);
  EXPECT_NEAR(box.min().y(), 4, 1e-12);
  EXPECT_NEAR(box.max().y(), 4, 1e-12);
}

TEST_F(GuidesOfOne, VerticesWithPlanesOfTheirOwnHaveOneEach)
{
  const auto guides = guidesOf(SlideConstraint{{VertexIds{{14, 19, 24}}}, OnPlane{{}, {0, 1, 0}}});
  ASSERT_EQ(guides.size(), 3);
  EXPECT_NEAR(guides[0].center.y(), 2, 1e-12);
  EXPECT_NEAR(guides[2].center.y(), 4, 1e-12);
}

TEST_F(GuidesOfOne, AMirrorIsAsLargeAsTheMesh)
{
  const auto guides = guidesOf(MirrorConstraint{{2, 0, 0}, {-3, 0, 0}, {}, {AllOf{}}, {}});
  ASSERT_EQ(guides.size(), 1);
  Eigen::AlignedBox3d box;
  for (const Vector3& corner : cornersOf(guides[0])) box.extend(corner);
  EXPECT_NEAR(box.min().x(), 2, 1e-12);
  EXPECT_NEAR(box.max().x(), 2, 1e-12);
  EXPECT_LT(box.min().y(), 0);
  EXPECT_GT(box.max().y(), 4);
}

TEST_F(GuidesOfOne, TolerancesAreDrawnToScaleAroundTheStatedTarget)
{
  const Vector3 target(4.5, 4, 1);
  const auto point = [&](const PointTolerance& within) {
    return guidesOf(PointConstraint{AtVertex{24}, Target{target}, within});
  };
  const auto ball = point(WithinBall{0.25});
  ASSERT_EQ(ball.size(), 1);
  EXPECT_EQ(ball[0].shape, GuideShape::Ball);
  EXPECT_NEAR(farthest(outlineOf(ball[0]), target), 0.25, 1e-12);
  const auto box = point(WithinBox{{0.1, 0.2, 0.2}});
  ASSERT_EQ(box.size(), 1);
  EXPECT_EQ(outlineOf(box[0]).size(), 12);
  EXPECT_NEAR(farthest(outlineOf(box[0]), target), 0.3, 1e-12);
  const auto slab = point(WithinSlab{-0.1, 0.3, Vector3(0, 0, 2)});
  ASSERT_EQ(slab.size(), 3);
  EXPECT_NEAR(cornersOf(slab[0])[0].z(), 0.9, 1e-12);
  EXPECT_NEAR(cornersOf(slab[1])[0].z(), 1.3, 1e-12);
  EXPECT_EQ(slab[2].shape, GuideShape::Distance);
  EXPECT_TRUE(point(Weighted{3}).empty());
}

TEST_F(GuidesOfOne, AToleranceOfALineIsACylinder)
{
  const auto guides = guidesOf(PointConstraint{AtVertex{24}, OnLine{Vector3(4, 4, 1), {0, 0, 1}}, WithinBall{0.25}});
  ASSERT_EQ(guides.size(), 2);
  EXPECT_EQ(guides[1].shape, GuideShape::Cylinder);
  for (const auto& line : outlineOf(guides[1]))
    for (const Vector3& end : line) EXPECT_NEAR((end - Vector3(4, 4, end.z())).norm(), 0.25, 1e-12);
}

}  // namespace
}  // namespace holdfast
