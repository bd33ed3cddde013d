#include <numbers>

#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>

#include "support/constraint_systems.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using test::hold;
using test::listOf;
using test::moveBy;
using test::rigid;
using test::systemOf;
using Terms = std::vector<Term>;

Constraint relative(SurfaceLocation from, SurfaceLocation to, std::optional<Vector3> offset = {})
{
  return {"", true, RelativeConstraint{std::move(from), std::move(to), std::move(offset)}};
}

Constraint turning(std::vector<Index> vertices, decltype(HandleConstraint::motion) motion)
{
  HandleConstraint handle{{VertexIds{std::move(vertices)}}, {}, Vector3(0, 0, 1), {}};
  handle.motion = std::move(motion);
  return {"", true, handle};
}

Vector3 rotationOf(const ConstraintSystem& system, Index unknown)
{
  for (const GivenRotation& rotation : system.rotations)
    if (rotation.unknown == unknown) return rotation.q;
  ADD_FAILURE() << "the rotation of " << unknown << " is not given";
  return Vector3::Zero();
}

TEST(RigidRows, TieEveryUnknownOfTheRegionToItsFirst)
{
  const Mesh mesh = test::grid(2, 2);
  const ConstraintSystem system = systemOf(mesh, listOf({hold({0}), rigid({7, 3, 4})}));
  ASSERT_EQ(system.rows.size(), 3U);
  ASSERT_EQ(system.rotated.size(), 2U);
  EXPECT_EQ(system.rigidRegions, (std::vector<std::vector<Index>>{{3, 4, 7}}));
  for (std::size_t k = 0; k < 2; ++k) {
    const Index vertex = system.rigidRegions[0][k + 1];
    const ConstraintRow& row = system.rows[k + 1];
    const Vector3 rest = (mesh.positions.row(vertex) - mesh.positions.row(3)).transpose();
    EXPECT_EQ(row.terms, (Terms{{3, -1}, {vertex, 1}}));
    EXPECT_EQ(row.kind, RowKind::Region);
    EXPECT_EQ(row.target, rest);
    EXPECT_EQ(row.shift, Vector3::Zero());
    EXPECT_EQ(row.constraint, 1);
    EXPECT_EQ(system.rotated[k].row, static_cast<Index>(k) + 1);
    EXPECT_EQ(system.rotated[k].rest, rest);
    EXPECT_EQ(system.rotated[k].rotation, (Terms{{3, 1}})) << "all turn as the first does";
  }
}

TEST(RigidRows, TurnAsTheMemberWhoseRotationIsGivenFirst)
{
  const AxisRotation quarter{Vector3(0, 0, 1), 90, Vector3::Zero()};
  const ConstraintSystem system =
      systemOf(test::grid(2, 2), listOf({hold({0}), turning({7}, quarter), hold({3}), rigid({3, 4, 7})}));
  ASSERT_EQ(system.rotated.size(), 2U);
  for (const RotatedVector& rotated : system.rotated) EXPECT_EQ(rotated.rotation, (Terms{{7, 1}}));
}

TEST(RigidRows, OfRegionsThatOverlapTurnAsOne)
{
  const AxisRotation quarter{Vector3(0, 0, 1), 90, Vector3::Zero()};
  const ConstraintSystem system = systemOf(
      test::grid(2, 2), listOf({turning({8}, quarter), hold({0}), rigid({0, 1}), rigid({1, 8}), rigid({3, 6})}));
  ASSERT_EQ(system.rotated.size(), 3U);
  EXPECT_EQ(system.rotated[0].rotation, (Terms{{8, 1}}));
  EXPECT_EQ(system.rotated[1].rotation, (Terms{{8, 1}}));
  EXPECT_EQ(system.rotated[2].rotation, (Terms{{3, 1}})) << "no rotation of this region is given";
}

TEST(RigidRows, OfWeldedVerticesAskOnce)
{
  const ConstraintSystem system =
      systemOf(test::soup(test::grid(2, 2)), listOf({{"", true, RigidConstraint{{InBox{{1, 1, 0}, {2, 1, 0}}}}}}));
  ASSERT_EQ(system.rigidRegions.size(), 1U);
  EXPECT_EQ(system.rigidRegions[0].size(), 2U);
  EXPECT_EQ(system.rows.size(), 1U);
}

TEST(RigidRows, OfOneVertexAreNone)
{
  const ConstraintSystem system = systemOf(test::grid(2, 2), listOf({rigid({4})}));
  EXPECT_TRUE(system.rows.empty());
  EXPECT_EQ(system.rigidRegions, (std::vector<std::vector<Index>>{{4}}));
}

TEST(RelativeRows, TakeOnePointFromTheOther)
{
  const Mesh mesh = test::grid(2, 2);
  const ConstraintSystem system =
      systemOf(mesh, listOf({relative(AtEdge{4, 1, 0.25}, AtVertex{4}), relative(AtVertex{8}, AtVertex{0})}));
  ASSERT_EQ(system.rows.size(), 2U);
  EXPECT_EQ(system.rows[0].terms, (Terms{{1, 0.75}, {4, -0.75}}));
  EXPECT_EQ(system.rows[0].target, Vector3(0, -0.75, 0));
  EXPECT_EQ(system.rows[1].terms, (Terms{{0, -1}, {8, 1}}));
  EXPECT_EQ(system.rows[1].target, Vector3(2, 2, 0));
  ASSERT_EQ(system.rotated.size(), 2U);
  EXPECT_EQ(system.rotated[0].rotation, (Terms{{1, 0.375}, {4, 0.625}})) << "half of what each end turns by";
  EXPECT_EQ(system.rotated[1].rotation, (Terms{{0, 0.5}, {8, 0.5}}));
  for (const ConstraintRow& row : system.rows) {
    EXPECT_EQ(row.kind, RowKind::Relative);
    EXPECT_EQ(row.shift, Vector3::Zero());
    EXPECT_FALSE(row.isPin());
  }
}

TEST(RelativeRows, WithAnOffsetTakeItAndDoNotTurn)
{
  const ConstraintSystem system =
      systemOf(test::grid(2, 2), listOf({relative(AtVertex{8}, AtVertex{0}, Vector3(0, 0, 25.5))}));
  ASSERT_EQ(system.rows.size(), 1U);
  EXPECT_EQ(system.rows[0].target, Vector3(0, 0, 25.5));
  EXPECT_EQ(system.rows[0].shift, Vector3(-2, -2, 25.5));
  EXPECT_TRUE(system.rotated.empty());
}

TEST(RelativeRows, OfAPointAndItselfAreEmpty)
{
  const ConstraintSystem system = systemOf(
      test::grid(2, 2),
      listOf({relative(AtVertex{4}, AtEdge{4, 1, 1}), relative(AtNear{{1, 1, 5}}, AtVertex{4}, Vector3(1, 0, 0))}));
  ASSERT_EQ(system.rows.size(), 2U);
  EXPECT_TRUE(system.rows[0].terms.empty());
  EXPECT_EQ(system.rows[0].target, Vector3::Zero());
  EXPECT_TRUE(system.rows[1].terms.empty());
  EXPECT_EQ(system.rows[1].shift, Vector3(1, 0, 0));
}

TEST(GivenRotations, AreThoseOfFixedVerticesAndHandles)
{
  const AxisRotation twice{{0, 0, 2}, 720, std::nullopt};
  const ConstraintSystem system = systemOf(
      test::grid(2, 2),
      listOf({hold({0, 1}), turning({6, 7}, twice), turning({8}, {}), moveBy(AtVertex{4}, {0, 0, 1}), rigid({2, 5})}));
  ASSERT_EQ(system.rotations.size(), 5U) << "points and rigid regions leave theirs free";
  EXPECT_EQ(rotationOf(system, 0), Vector3::Zero());
  EXPECT_EQ(rotationOf(system, 6), Vector3(0, 0, 2 * std::numbers::pi)) << "two turns are not none";
  EXPECT_EQ(rotationOf(system, 8), Vector3::Zero());
  EXPECT_EQ(system.rotations[2].constraint, 1);
}

TEST(GivenRotations, OfTheEarlierConstraintStand)
{
  const AxisRotation quarter{{0, 0, 1}, 90, std::nullopt};
  const ConstraintSystem first = systemOf(test::grid(2, 2), listOf({hold({4, 5}), turning({4, 6}, quarter)}));
  ASSERT_EQ(first.rotations.size(), 3U);
  EXPECT_EQ(rotationOf(first, 4), Vector3::Zero());
  const ConstraintSystem second = systemOf(test::grid(2, 2), listOf({turning({4, 6}, quarter), hold({4, 5})}));
  ASSERT_EQ(second.rotations.size(), 3U);
  EXPECT_EQ(rotationOf(second, 4), Vector3(0, 0, std::numbers::pi / 4));
}

TEST(DisabledConstraints, GiveNoRotationNoBodyAndNoDifference)
{
  ConstraintList list = listOf({hold({0}), turning({6, 7}, {}), rigid({2, 5}), relative(AtVertex{8}, AtVertex{0}),
                                relative(AtVertex{8}, AtVertex{0}, Vector3(1, 1, 1))});
  for (Constraint& constraint : list.constraints) constraint.isEnabled = false;
  const ConstraintSystem system = systemOf(test::grid(2, 2), list);
  EXPECT_TRUE(system.rows.empty());
  EXPECT_TRUE(system.rotated.empty());
  EXPECT_TRUE(system.rotations.empty());
  EXPECT_TRUE(system.rigidRegions.empty());
}

}  // namespace
}  // namespace holdfast
