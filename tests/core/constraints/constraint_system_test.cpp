#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>

#include "support/constraint_systems.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using test::handle;
using test::hold;
using test::listOf;
using test::moveBy;
using test::moveTo;
using test::systemOf;

/// Returns where a handle takes the vertices of a mesh that consists of `points` and one face among them.
std::vector<Vector3> rotated(const std::vector<Vector3>& points, const AxisRotation& turn)
{
  Mesh mesh{Positions(static_cast<Index>(points.size()), 3), {}};
  std::vector<Index> all;
  for (std::size_t v = 0; v < points.size(); ++v) {
    mesh.positions.row(static_cast<Index>(v)) = points[v];
    all.push_back(static_cast<Index>(v));
  }
  mesh.faces.add({0, 1, 2});
  std::vector<Vector3> result;
  for (const ConstraintRow& row : systemOf(mesh, listOf({handle(all, turn, Vector3::Zero())})).rows)
    result.push_back(row.target);
  return result;
}

TEST(ConstraintSystem, FixedVerticesArePinnedWhereTheyAre)
{
  const Mesh mesh = test::icosphere(1);
  const ConstraintSystem system = systemOf(mesh, listOf({hold({7, 3})}));
  ASSERT_EQ(system.rows.size(), 2U);
  for (const ConstraintRow& row : system.rows) {
    EXPECT_TRUE(row.isPin());
    EXPECT_EQ(row.terms[0].coefficient, 1);
    EXPECT_EQ(row.target, Vector3(mesh.positions.row(row.terms[0].index)));
    EXPECT_EQ(row.shift, Vector3::Zero());
    EXPECT_EQ(row.constraint, 0);
  }
  EXPECT_EQ(system.rows[0].terms[0].index, 3) << "the vertices of a selection ascend";
}

TEST(ConstraintSystem, RowsComeInTheOrderOfTheList)
{
  const ConstraintSystem system = systemOf(
      test::grid(2, 2), listOf({moveBy(AtVertex{8}, {0, 0, 1}), hold({0, 1}), moveBy(AtVertex{4}, {0, 0, 2})}));
  ASSERT_EQ(system.rows.size(), 4U);
  const std::vector<Index> expected{0, 1, 1, 2};
  for (std::size_t r = 0; r < 4; ++r) EXPECT_EQ(system.rows[r].constraint, expected[r]);
}

TEST(ConstraintSystem, PointsHangOnTheVerticesThatTheFileNames)
{
  const Mesh mesh = test::grid(2, 2);
  const ConstraintSystem system = systemOf(
      mesh, listOf({moveTo(AtEdge{4, 1, 0.25}, {5, 6, 7}), moveBy(AtFace{0, {0.5, 0.125, 0.375}}, {1, 2, 3})}));
  EXPECT_EQ(system.rows[0].terms, (std::vector<Term>{{1, 0.75}, {4, 0.25}}));
  EXPECT_EQ(system.rows[0].target, Vector3(5, 6, 7));
  EXPECT_EQ(system.rows[0].shift, Vector3(5 - 1, 6 - 0.25, 7));
  EXPECT_EQ(system.rows[1].terms, (std::vector<Term>{{0, 0.5}, {1, 0.125}, {4, 0.375}}));
  EXPECT_EQ(system.rows[1].shift, Vector3(1, 2, 3));
  EXPECT_EQ(system.rows[1].target, Vector3(1 + 0.5, 2 + 0.375, 3));
  EXPECT_EQ(system.rows[0].corners, 2);
  EXPECT_EQ(system.rows[1].corners, 3);
}

TEST(ConstraintSystem, PointsWithVanishingWeightsBecomePins)
{
  const ConstraintSystem system =
      systemOf(test::grid(2, 2), listOf({moveBy(AtEdge{4, 1, 1}, {0, 0, 1}), moveBy(AtFace{0, {0, 1, 0}}, {0, 0, 2})}));
  EXPECT_EQ(system.rows[0].terms, (std::vector<Term>{{4, 1}}));
  EXPECT_EQ(system.rows[1].terms, (std::vector<Term>{{1, 1}}));
}

TEST(ConstraintSystem, PolygonsTakeAWeightForEachCorner)
{
  const Mesh mesh = test::polygonPlate(1, 1);
  const ConstraintSystem system =
      systemOf(mesh, listOf({moveBy(AtFace{0, {0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125, 0.125}}, {0, 0, 1})}));
  EXPECT_EQ(system.rows[0].terms.size(), 8U);
}

TEST(ConstraintSystem, NearPlacesBecomeTheClosestPoint)
{
  const ConstraintSystem system =
      systemOf(test::grid(2, 2),
               listOf({moveTo(AtNear{{0.5, 1, 3}}, {9, 9, 9}), hold({0}), moveTo(AtNear{{2, 2, 0}}, {1, 1, 1})}));
  EXPECT_EQ(system.rows[0].terms, (std::vector<Term>{{3, 0.5}, {4, 0.5}}));
  EXPECT_EQ(system.rows[0].target, Vector3(9, 9, 9));
  EXPECT_EQ(system.rows[0].shift, Vector3(8.5, 8, 9)) << "from the surface, not from the place";
  EXPECT_EQ(system.rows[2].terms, (std::vector<Term>{{8, 1}}));
}

TEST(ConstraintSystem, QuarterTurnsAreExact)
{
  const Vector3 x(1, 0, 0);
  const Vector3 p(0.1, -0.7, 1e-3);
  const auto turn = [](double degrees, const Vector3& axis) { return AxisRotation{axis, degrees, Vector3(0, 0, 0)}; };
  const auto about = [&](double degrees, const Vector3& axis) { return rotated({x, p, 3 * p}, turn(degrees, axis)); };
  for (const double whole : {0.0, 360.0, -360.0, 3600.0}) {
    EXPECT_EQ(about(whole + 90, {0, 0, 1})[0], Vector3(0, 1, 0)) << whole;
    EXPECT_EQ(about(whole + 90, {0, 0, 1})[1], Vector3(0.7, 0.1, 1e-3)) << whole;
    EXPECT_EQ(about(whole + 180, {0, 0, 5})[1], Vector3(-0.1, 0.7, 1e-3)) << whole;
    EXPECT_EQ(about(whole - 90, {0, 0, 1})[1], Vector3(-0.7, -0.1, 1e-3)) << whole;
    EXPECT_EQ(about(whole + 90, {0, 0, -2})[1], Vector3(-0.7, -0.1, 1e-3)) << whole;
    EXPECT_EQ(about(whole + 270, {1, 0, 0})[1], Vector3(0.1, 1e-3, 0.7)) << whole;
    EXPECT_EQ(about(whole, {0, 1, 0})[1], p) << whole;
  }
}

TEST(ConstraintSystem, TurnsAreRotationsAboutTheirCenter)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    test::Random random(seed);
    const AxisRotation turn{test::randomVector(random, 3), random.uniform(-720, 720), test::randomVector(random, 2)};
    std::vector<Vector3> points;
    for (int k = 0; k < 5; ++k) points.push_back(test::randomVector(random, 1));
    const std::vector<Vector3> moved = rotated(points, turn);
    const Eigen::AngleAxisd rotation(turn.degrees * std::numbers::pi / 180, turn.axis.normalized());
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_LT((moved[k] - (rotation * (points[k] - *turn.center) + *turn.center)).norm(), 1e-14);
  }
}

TEST(ConstraintSystem, HandlesTurnAboutTheirCentroidWhereNoCenterIsGiven)
{
  const std::vector<Vector3> moved =
      rotated({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, AxisRotation{{0, 0, 1}, 180, std::nullopt});
  EXPECT_EQ(moved[0], Vector3(2, 2, 0));
  EXPECT_EQ(moved[1], Vector3(-1, 2, 0));
}

TEST(ConstraintSystem, HandlesTranslateAfterTheirTurn)
{
  const Mesh mesh = test::grid(1, 1);
  const AxisRotation turn{{0, 0, 1}, 90, Vector3(0, 0, 0)};
  const ConstraintSystem system =
      systemOf(mesh, listOf({handle({1}, turn, {0, 0, 5}), handle({2}, {}, {0.1, 0.2, 0.3})}));
  EXPECT_EQ(system.rows[0].target, Vector3(0, 1, 5));
  EXPECT_EQ(system.rows[0].shift, Vector3(-1, 1, 5));
  EXPECT_EQ(system.rows[1].target, Vector3(0 + 0.1, 1 + 0.2, 0.3));
}

TEST(ConstraintSystem, DisabledConstraintsMakeNoRowsYetTheirPlacesAreChecked)
{
  ConstraintList list = listOf({moveTo(AtNear{{0.5, 1, 3}}, {9, 9, 9}), hold({0})});
  for (Constraint& constraint : list.constraints) constraint.isEnabled = false;
  EXPECT_TRUE(systemOf(test::grid(2, 2), list).rows.empty());
  std::get<PointConstraint>(list.constraints[0].what).at = AtVertex{1000};
  EXPECT_THROW(static_cast<void>(systemOf(test::grid(2, 2), list)), InputError);
}

TEST(ConstraintSystem, WeldedVerticesOfOneSelectionAskOnce)
{
  const Mesh mesh = test::soup(test::grid(2, 2));
  ConstraintList list = listOf({{"", true, FixedConstraint{{InBox{{1, 1, 0}, {1, 1, 0}}}}}});
  EXPECT_EQ(systemOf(mesh, list).rows.size(), 1U) << "six corners of the middle are one unknown";
  list.constraints.push_back(list.constraints[0]);
  EXPECT_EQ(systemOf(mesh, list).rows.size(), 2U) << "another constraint asks for itself";
}

TEST(ConstraintSystem, PointsOfASoupHangOnItsUnknowns)
{
  const Mesh mesh = test::soup(test::grid(1, 1));
  const ConstraintSystem system =
      systemOf(mesh, listOf({moveBy(AtEdge{0, 2, 0.25}, {0, 0, 1}), moveBy(AtEdge{3, 4, 0.25}, {0, 0, 1})}));
  EXPECT_EQ(system.rows[0].terms, system.rows[1].terms) << "the diagonal, seen from both faces";
  EXPECT_EQ(system.rows[1].corners, 2) << "of the file";
}

}  // namespace
}  // namespace holdfast
