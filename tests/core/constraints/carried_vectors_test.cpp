#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/constraint_systems.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using test::listOf;
using test::systemOf;

ConstraintList groupAndDistance()
{
  return listOf({{"", true, RigidConstraint{{VertexIds{{0, 1, 3}}}}},
                 {"", true, RelativeConstraint{AtVertex{8}, AtVertex{6}, std::nullopt}},
                 {"", true, RelativeConstraint{AtVertex{7}, AtVertex{5}, Vector3(1, 2, 3)}},
                 test::moveBy(AtVertex{4}, {0, 0, 1})});
}

Columns3 everywhere(const Vector3& q, Index unknowns)
{
  return q.transpose().replicate(unknowns, 1);
}

TEST(CarriedVectors, TurnWithTheSurface)
{
  const ConstraintSystem rest = systemOf(test::grid(2, 2), groupAndDistance());
  const ConstraintSystem system = rotated(rest, everywhere(rotationLog(Vector3(0, 0, 1), 90), 9));
  EXPECT_EQ(system.rows[0].target, Vector3(0, 1, 0)) << "from vertex 0 to vertex 1, along x at rest";
  EXPECT_EQ(system.rows[0].shift, Vector3(-1, 1, 0));
  EXPECT_EQ(system.rows[1].target, Vector3(-1, 0, 0)) << "from vertex 0 to vertex 3, along y at rest";
  EXPECT_EQ(system.rows[2].target, Vector3(0, 2, 0)) << "from vertex 6 to vertex 8";
  EXPECT_EQ(system.rows[2].shift, Vector3(-2, 2, 0));
}

TEST(CarriedVectors, LeaveOtherRowsAlone)
{
  const ConstraintSystem rest = systemOf(test::grid(2, 2), groupAndDistance());
  const ConstraintSystem system = rotated(rest, everywhere({1, 2, 3}, 9));
  for (const std::size_t row : {3, 4}) {
    EXPECT_EQ(system.rows[row].target, rest.rows[row].target);
    EXPECT_EQ(system.rows[row].shift, rest.rows[row].shift);
  }
}

TEST(CarriedVectors, OfABodyTurnAsItsFirstUnknownDoes)
{
  Columns3 q = everywhere({1, 2, 3}, 9);
  q.row(0) = rotationLog(Vector3(0, 0, 1), 90).transpose();
  const ConstraintSystem system = rotated(systemOf(test::grid(2, 2), groupAndDistance()), q);
  EXPECT_EQ(system.rows[0].target, Vector3(0, 1, 0));
  EXPECT_EQ(system.rows[1].target, Vector3(-1, 0, 0));
}

TEST(CarriedVectors, BetweenTwoPointsTurnHalfAsEachEnd)
{
  Columns3 q = everywhere({1, 2, 3}, 9);
  q.row(6) = rotationLog(Vector3(0, 0, 1), 180).transpose();
  q.row(8) = Vector3::Zero().transpose();
  EXPECT_EQ(rotated(systemOf(test::grid(2, 2), groupAndDistance()), q).rows[2].target, Vector3(0, 2, 0));
}

TEST(CarriedVectors, AreAsAtRestWithoutRotationBitForBit)
{
  const Mesh mesh = test::icosphere(1);
  const ConstraintSystem rest = systemOf(mesh, groupAndDistance());
  const ConstraintSystem once = rotated(rest, everywhere({1, 2, 3}, mesh.vertexCount()));
  const ConstraintSystem back = rotated(once, everywhere(Vector3::Zero(), mesh.vertexCount()));
  for (std::size_t row = 0; row < rest.rows.size(); ++row) {
    EXPECT_EQ(back.rows[row].target, rest.rows[row].target);
    EXPECT_EQ(back.rows[row].shift, rest.rows[row].shift);
  }
}

TEST(CarriedVectors, KeepTheirLength)
{
  const Mesh mesh = test::icosphere(1);
  const ConstraintSystem rest = systemOf(mesh, groupAndDistance());
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    Columns3 q(mesh.vertexCount(), 3);
    for (Index u = 0; u < q.rows(); ++u) q.row(u) = test::randomVector(random, 5).transpose();
    const ConstraintSystem system = rotated(rest, q);
    for (const RotatedVector& rotated : rest.rotated)
      EXPECT_NEAR(system.rows[rotated.row].target.norm(), rotated.rest.norm(), 1e-15);
  }
}

}  // namespace
}  // namespace holdfast
