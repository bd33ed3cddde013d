#include <gtest/gtest.h>

#include <holdfast/document/constraint_drag.h>
#include <holdfast/geometry/rotation_log.h>

#include "holdfast/document/handle_restated.h"
#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

constexpr double kRounding = 1e-14;

void expectAxes(const Eigen::Matrix3d& axes)
{
  EXPECT_LT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), kRounding);
  EXPECT_GT(axes.determinant(), 0);
}

TEST(OwnAxes, AboutADirectionAreOrthonormalWithItAsTheThird)
{
  for (const Vector3& direction :
       {Vector3(0, 0, 3), Vector3(-1, 0, 0), Vector3(1e-200, 2e-200, 0), Vector3(1, 2, -3)}) {
    const Eigen::Matrix3d axes = axesAbout(direction);
    expectAxes(axes);
    EXPECT_LT((axes.col(2) - direction.stableNormalized()).norm(), kRounding);
  }
  EXPECT_EQ(axesAbout(Vector3::Zero()), Eigen::Matrix3d::Identity());
  EXPECT_EQ(axesAbout({0, 0, 1}), Eigen::Matrix3d::Identity());
}

TEST(OwnAxes, OfAPointLieAcrossAndAlongTheFacesThatItIsIn)
{
  // Vertex 0 is a corner of the box: three faces meet there. The edge from it to vertex 1 has two.
  const Model model = makeModel(test::box({2, 2, 2}, 1), "box");
  const Positions& rest = model.mesh.positions;
  const Vector3 middle = rest.colwise().mean().transpose();
  for (Index f = 0; f < model.mesh.faces.size(); ++f) {
    const auto face = model.mesh.faces[f];
    const double third = 1.0 / 3;
    const SurfacePoint inside = canonical({{face[0], third}, {face[1], third}, {face[2], third}});
    const Vector3 a = rest.row(face[0]);
    const Vector3 normal = (Vector3(rest.row(face[1])) - a).cross(Vector3(rest.row(face[2])) - a).normalized();
    EXPECT_LT((surfaceAxes(model, inside, rest).col(2) - normal).norm(), kRounding);
  }
  for (Index v = 0; v < rest.rows(); ++v) {
    const Eigen::Matrix3d axes = surfaceAxes(model, canonical({{v, 1.0}}), rest);
    expectAxes(axes);
    // Out of the corner: each of the three sides has its share.
    EXPECT_GT(axes.col(2).dot(Vector3(rest.row(v)) - middle), 0.5);
  }
}

TEST(OwnAxes, OfAPointFollowTheSurfaceThatIsShown)
{
  const Model model = makeModel(test::grid(2, 2), "grid");
  const Eigen::Matrix3d R = rotationMatrix({1, 2, 3}, 50);
  const Positions rotated = model.mesh.positions * R.transpose();
  const SurfacePoint middle = canonical({{4, 1.0}});
  EXPECT_LT((surfaceAxes(model, middle, rotated).col(2) - R.col(2)).norm(), kRounding);
}

TEST(OwnAxes, OfAPointOnASeamSeeTheFacesOfBothSides)
{
  // Two squares at right angles, whose common edge has vertices of its own in each.
  Mesh mesh;
  mesh.positions.resize(8, 3);
  mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1;
  mesh.faces.add({0, 1, 2, 3});
  mesh.faces.add({4, 5, 6, 7});
  const Model model = makeModel(std::move(mesh), "seam");
  const Vector3 normal = surfaceAxes(model, canonical({{0, 0.5}, {3, 0.5}}), model.mesh.positions).col(2);
  EXPECT_LT((normal - Vector3(1, 0, 1).normalized()).norm(), kRounding);
}

TEST(OwnAxes, ArePrincipalOfAShaftAndOfAPlateAndOfNoBall)
{
  const Eigen::Matrix3d R = rotationMatrix({3, -1, 2}, 77);
  const auto rotated = [&](const Mesh& mesh) { return Positions(mesh.positions * R.transpose()); };
  EXPECT_NEAR(std::abs(principalAxes(rotated(test::box({1, 1, 9}, 3))).col(2).dot(R.col(2))), 1, kRounding);
  EXPECT_NEAR(std::abs(principalAxes(rotated(test::box({6, 6, 1}, 3))).col(2).dot(R.col(2))), 1, kRounding);
  EXPECT_EQ(principalAxes(rotated(test::icosphere(2))), Eigen::Matrix3d::Identity());
  Positions one(1, 3);
  one << 4, 5, 6;
  EXPECT_EQ(principalAxes(one), Eigen::Matrix3d::Identity());
}

TEST(OwnAxes, OfHandlesOfEveryKindTurnWithThem)
{
  const Model model = makeModel(test::quadBox({1, 1, 6}, 4), "bar");
  const Selection top{InHalfSpace{{0, 0, 3}, {0, 0, 1}}};
  const Selection base{InHalfSpace{{0, 0, 0.1}, {0, 0, -1}}};
  const auto axesOfHandle = [&](const HandleConstraint& handle) {
    const ConstraintList list{"", {{"base", true, FixedConstraint{base}}, {"top", true, handle}}};
    const Index place = 1;
    return ConstraintDrag(model, list, {&place, 1}, "list").axes(model.mesh.positions);
  };
  const Eigen::Matrix3d still = axesOfHandle({top, {}, {0, 0, 0}, {}});
  EXPECT_LT((still.col(2) - Vector3::UnitZ()).norm(), kRounding) << "the axis of the bar";
  const Eigen::Matrix3d R = rotationMatrix({1, 0, 0}, 40);
  EXPECT_LT((axesOfHandle({top, AxisRotation{{1, 0, 0}, 40, {}}, {0, 0, 0}, {}}) - R * still).norm(), kRounding);
  const Frame from{{}, {1, 0, 0}, {0, 1, 0}};
  const Frame to{{}, R.col(0), R.col(1)};
  EXPECT_LT((axesOfHandle({top, FrameMotion{from, to, 0}, {0, 0, 0}, {}}) - R).norm(), kRounding);
  // Seen from the middle of the fixed end the handle goes from z by its shift.
  const HandleConstraint about{top, RotationAboutFixed{}, {0, 2, -1}, {}};
  const Eigen::Matrix3d rotated = axesOfHandle(about);
  expectAxes(rotated);
  EXPECT_GT(rotated(1, 2), 0.2) << "z leans the way the handle went";
}

}  // namespace
}  // namespace holdfast
