#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <holdfast/constraints/handle_drag.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/constraint_systems.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using std::numbers::pi;

// Roundings of a few dozen operations on numbers up to 100.
constexpr double kRoundingOfDrags = 1e-11;

const InputLocation kWhere{"list", 0, "handle"};

/// The handle holds five vertices of a grid, listed in no order; one corner of the grid is fixed.
struct Dragged {
  Mesh mesh = test::grid(4, 4);
  std::vector<Index> vertices{24, 13, 18, 19, 23};

  [[nodiscard]] HandleConstraint handle(decltype(HandleConstraint::motion) motion,
                                        const Vector3& translate = Vector3::Zero()) const
  {
    return {{VertexIds{vertices}}, std::move(motion), translate, {}};
  }

  [[nodiscard]] Positions rest() const
  {
    Positions result(static_cast<Index>(vertices.size()), 3);
    for (std::size_t k = 0; k < vertices.size(); ++k) result.row(k) = mesh.positions.row(vertices[k]);
    return result;
  }

  [[nodiscard]] HandleConstraint after(const HandleConstraint& handle, const RigidIncrement& increment) const
  {
    const Vector3 fixed = mesh.positions.row(0).transpose();
    return composed(handle, increment, {rest(), {fixed, std::sqrt(32)}, kWhere});
  }

  /// What the core makes of the handle. Of each file vertex of the handle: its target, and its rotation.
  [[nodiscard]] ConstraintSystem system(const HandleConstraint& handle) const
  {
    return test::systemOf(mesh, test::listOf({test::hold({0}), {"", true, handle}}));
  }

  /// Degrees of the first vertex, as the surface is given them.
  [[nodiscard]] double degreesOf(const HandleConstraint& handle) const
  {
    return angleDegrees(system(handle).rotations.back().q);
  }
};

std::vector<decltype(HandleConstraint::motion)> motions(test::Random& random)
{
  const auto some = [&](double size) { return test::randomVector(random, size); };
  VertexTargets targets;
  for (int k = 0; k < 5; ++k) targets.places.push_back(some(4));
  return {std::monostate{},
          AxisRotation{some(2), 400, some(3)},
          AxisRotation{some(2), -70, std::nullopt},
          FrameMotion{{some(2), {1, 0.2, 0}, {0, 1, 0.1}}, {some(2), {0, 2, 1}, {1, 0, 0}}, 0},
          FrameMotion{{std::nullopt, {1, 0.2, 0}, {0, 1, 0.1}}, {std::nullopt, {0, 2, 1}, {1, 0, 0}}, 2},
          FrameMotion{},
          targets};
}

RigidIncrement randomIncrement(test::Random& random)
{
  return {test::randomVector(random, 2), random.uniform(-800, 800), test::randomVector(random, 4),
          test::randomVector(random, 3)};
}

Vector3 moved(const Vector3& place, const RigidIncrement& by)
{
  return Eigen::AngleAxisd(by.degrees / 180 * pi, by.axis.normalized()) * (place - by.pivot) + by.pivot +
         by.translation;
}

void expectMovedBy(const RigidIncrement& increment, const ConstraintSystem& before, const ConstraintSystem& after)
{
  const Eigen::Matrix3d R = Eigen::AngleAxisd(increment.degrees / 180 * pi, increment.axis.normalized()).matrix();
  ASSERT_EQ(after.rows.size(), before.rows.size());
  ASSERT_EQ(after.rotations.size(), before.rotations.size());
  for (std::size_t r = 1; r < after.rows.size(); ++r) {
    EXPECT_EQ(after.rows[r].terms, before.rows[r].terms);
    EXPECT_LT((after.rows[r].target - moved(before.rows[r].target, increment)).norm(), kRoundingOfDrags);
    const Eigen::Matrix3d expected = R * rotationMatrix(before.rotations[r].q);
    EXPECT_LT((rotationMatrix(after.rotations[r].q) - expected).cwiseAbs().maxCoeff(), kRoundingOfDrags);
  }
}

TEST(HandleDrag, MovesWhatCoreMakesOfTheHandleByTheIncrement)
{
  const Dragged dragged;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    test::Random random(seed);
    for (const auto& motion : motions(random)) {
      SCOPED_TRACE(motion.index());
      HandleConstraint handle = dragged.handle(motion, test::randomVector(random, 2));
      for (int drag = 0; drag < 3; ++drag) {
        const RigidIncrement increment = randomIncrement(random);
        const HandleConstraint after = dragged.after(handle, increment);
        EXPECT_FALSE(validateHandle(after));
        // Places that fit no rotation well turn by the best one, which the law of rotations does not know of.
        if (std::holds_alternative<VertexTargets>(motion))
          for (std::size_t k = 0; k < 5; ++k)
            EXPECT_LT(
                (dragged.system(after).rows[k + 1].target - moved(dragged.system(handle).rows[k + 1].target, increment))
                    .norm(),
                kRoundingOfDrags);
        else
          expectMovedBy(increment, dragged.system(handle), dragged.system(after));
        handle = after;
      }
    }
  }
}

TEST(HandleDrag, TurnsPlacesThatARotationFits)
{
  const Dragged dragged;
  const Positions rest = dragged.rest();
  for (const double degrees : {0.0, 60.0, 150.0}) {
    VertexTargets targets;
    for (Index k = 0; k < rest.rows(); ++k)
      targets.places.emplace_back(rotationMatrix(Vector3(1, 2, 3), degrees) * rest.row(k).transpose());
    const HandleConstraint handle = dragged.handle(targets, {1, 0, 0});
    for (const double more : {20.0, 170.0, 300.0, -500.0}) {
      const RigidIncrement increment{{-1, 4, 0}, more, {1, 1, 1}, {0, 2, 0}};
      expectMovedBy(increment, dragged.system(handle), dragged.system(dragged.after(handle, increment)));
    }
  }
}

TEST(HandleDrag, TurnsRotationsOfSingleVertices)
{
  const Dragged dragged;
  test::Random random(5);
  for (const auto& motion : motions(random)) {
    HandleConstraint handle = dragged.handle(motion, {0, 0, 1});
    for (double degrees = 0; degrees < 500; degrees += 100) handle.rotations.push_back({{1, 0, 2}, degrees});
    const RigidIncrement increment = randomIncrement(random);
    expectMovedBy(increment, dragged.system(handle), dragged.system(dragged.after(handle, increment)));
  }
}

TEST(HandleDrag, WithoutIncrementIsIdentityBitForBit)
{
  const Dragged dragged;
  test::Random random(6);
  for (const auto& motion : motions(random)) {
    const HandleConstraint handle = dragged.handle(motion, test::randomVector(random, 2));
    const ConstraintSystem before = dragged.system(handle);
    for (const RigidIncrement& none :
         {RigidIncrement{}, RigidIncrement{{1, 2, 3}, 0, {4, 5, 6}, {0, 0, 0}},
          RigidIncrement{{0, 0, 0}, 90, {4, 5, 6}, {0, 0, 0}}, RigidIncrement{{1, 0, 0}, 0, {0, 0, 0}, {-0.0, 0, 0}}}) {
      const HandleConstraint after = dragged.after(handle, none);
      EXPECT_EQ(after.motion.index(), handle.motion.index());
      EXPECT_EQ(after.translate, handle.translate);
      const ConstraintSystem same = dragged.system(after);
      for (std::size_t r = 0; r < same.rows.size(); ++r) {
        EXPECT_EQ(same.rows[r].target, before.rows[r].target);
        EXPECT_EQ(same.rotations[r].q, before.rotations[r].q);
      }
    }
  }
}

TEST(HandleDrag, ATranslationIsAddedToTranslateOnly)
{
  const Dragged dragged;
  test::Random random(7);
  for (const auto& motion : motions(random)) {
    const HandleConstraint handle = dragged.handle(motion, {0.1, 0.2, 0.3});
    const HandleConstraint after = dragged.after(handle, {{0, 1, 0}, 0, {9, 9, 9}, {0.7, 0, -4}});
    EXPECT_EQ(after.motion.index(), handle.motion.index());
    EXPECT_EQ(after.translate, Vector3(0.1, 0.2, 0.3) + Vector3(0.7, 0, -4));
    if (std::holds_alternative<VertexTargets>(motion)) continue;
    const ConstraintSystem before = dragged.system(handle);
    const ConstraintSystem moved = dragged.system(after);
    for (std::size_t r = 0; r < moved.rows.size(); ++r) EXPECT_EQ(moved.rotations[r].q, before.rotations[r].q);
  }
}

TEST(HandleDrag, ThreeTurnsAboutTheSameAxisAre1080Degrees)
{
  const Dragged dragged;
  const RigidIncrement increment{{0, 1, 0}, 1080, {3, 3, 0}, {0, 0, 0}};
  const HandleConstraint fresh = dragged.after(dragged.handle({}), increment);
  EXPECT_EQ(std::get<AxisRotation>(fresh.motion).degrees, 1080);
  EXPECT_EQ(std::get<AxisRotation>(fresh.motion).axis, Vector3(0, 1, 0));
  EXPECT_EQ(*std::get<AxisRotation>(fresh.motion).center, Vector3(3, 3, 0));
  EXPECT_EQ(fresh.translate, Vector3(0, 0, 0));
  EXPECT_EQ(std::get<AxisRotation>(dragged.after(fresh, increment).motion).degrees, 2160);
  const HandleConstraint back = dragged.after(dragged.handle(AxisRotation{{0, -5, 0}, 90, {}}), increment);
  EXPECT_EQ(std::get<AxisRotation>(back.motion).degrees, 90 - 1080);
  EXPECT_EQ(std::get<AxisRotation>(back.motion).axis, Vector3(0, -5, 0));
}

TEST(HandleDrag, KeepsTurnsAboutAnAxisThatIsNearlyTheSame)
{
  const AxisAngle turn = composed(AxisAngle{{0, 0, 1}, 30}, AxisAngle{{1e-9, 0, 1}, 1082});
  EXPECT_NEAR(turn.degrees, 1112, 1e-6);
}

TEST(HandleDrag, KeepsTurnsAboutTheFramesAxis)
{
  const Dragged dragged;
  const HandleConstraint handle = dragged.handle(FrameMotion{});
  for (const double degrees : {90.0, 179.0, 181.0, 300.0, 360.0, 450.0, 1080.0, 1100.0, -540.5}) {
    const HandleConstraint after = dragged.after(handle, {{1, 1, 0}, degrees, {2, 2, 0}, {0, 0, 0}});
    EXPECT_NEAR(dragged.degreesOf(after), std::abs(degrees), kRoundingOfDrags) << degrees;
    EXPECT_EQ(std::holds_alternative<FrameMotion>(after.motion), std::fmod(degrees, 360) != 0) << degrees;
  }
}

TEST(HandleDrag, KeepsTurnsOfPlaces)
{
  const Dragged dragged;
  VertexTargets targets;
  const Positions rest = dragged.rest();
  for (Index k = 0; k < rest.rows(); ++k) targets.places.emplace_back(rest.row(k).transpose());
  for (const double degrees : {90.0, 179.0, 180.0, 181.0, 720.0}) {
    const HandleConstraint after = dragged.after(dragged.handle(targets), {{0, 1, 0}, degrees, {2, 2, 0}, {0, 0, 0}});
    EXPECT_NEAR(dragged.degreesOf(after), degrees, kRoundingOfDrags);
    EXPECT_TRUE(std::holds_alternative<VertexTargets>(after.motion));
    EXPECT_EQ(after.rotations.empty(), degrees < 180);
  }
}

TEST(HandleDrag, NeverJumpsOnItsWayThroughSeveralTurns)
{
  for (const AxisAngle& start :
       {AxisAngle{{1, 0, 0}, 10}, AxisAngle{{1, 0, 0}, 90}, AxisAngle{{0, 1, 1}, 500}, AxisAngle{{1, 2, 2}, -170}}) {
    Vector3 before = rotationLog(start.axis, start.degrees);
    for (double degrees = 0; degrees <= 1500; degrees += 0.5) {
      const AxisAngle turn = composed(start, AxisAngle{{1, 3, 1}, degrees});
      const Vector3 q = rotationLog(turn.axis, turn.degrees);
      ASSERT_LT((q - before).norm(), 0.2) << degrees;
      before = q;
    }
  }
}

TEST(HandleDrag, AboutTheHandlesPlaceMovesNothingElse)
{
  const Dragged dragged;
  const HandleConstraint rotated = dragged.handle(AxisRotation{{0, 0, 1}, 20, Vector3(3, 3, 0)}, {0, 0, 2});
  const HandleConstraint after = dragged.after(rotated, {{1, 0, 0}, 40, {3, 3, 2}, {0, 0, 0}});
  EXPECT_EQ(after.translate, Vector3(0, 0, 2));
  EXPECT_EQ(*std::get<AxisRotation>(after.motion).center, Vector3(3, 3, 0));
}

TEST(HandleDrag, WhatTurnsAboutTheFixedVerticesGoesOnDoingSoWhenMoved)
{
  const Dragged dragged;
  const HandleConstraint handle = dragged.handle(RotationAboutFixed{}, {-1, 0, 0.5});
  const HandleConstraint after = dragged.after(handle, {{0, 0, 1}, 0, {0, 0, 0}, {0, 0, 2}});
  EXPECT_TRUE(std::holds_alternative<RotationAboutFixed>(after.motion));
  EXPECT_EQ(after.translate, Vector3(-1, 0, 2.5));
}

TEST(HandleDrag, WhatTurnsAboutTheFixedVerticesSaysItsTurnOnceItIsTurned)
{
  const Dragged dragged;
  const HandleConstraint handle = dragged.handle(RotationAboutFixed{}, {-1, 0, 0.5});
  const RigidIncrement increment{{1, 2, 0}, 400, {1, 2, 3}, {0, 1, 0}};
  const HandleConstraint after = dragged.after(handle, increment);
  EXPECT_TRUE(std::holds_alternative<AxisRotation>(after.motion));
  expectMovedBy(increment, dragged.system(handle), dragged.system(after));
}

TEST(HandleDrag, WhatCannotTurnAboutTheFixedVerticesIsRefusedAtItsPlace)
{
  const Dragged dragged;
  const HandleConstraint handle = dragged.handle(RotationAboutFixed{});
  const RigidIncrement increment{{1, 0, 0}, 10, {0, 0, 0}, {0, 0, 0}};
  try {
    (void)composed(handle, increment, {dragged.rest(), {std::nullopt, 1}, kWhere});
    FAIL() << "there is nothing to turn about";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().element, "handle.turn");
  }
}

}  // namespace
}  // namespace holdfast
