#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/constraints/handle_motion.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/constraint_systems.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using std::numbers::pi;
using test::hold;
using test::listOf;
using test::systemOf;
using testing::HasSubstr;

// A few roundings of numbers up to 10.
constexpr double kRoundingOfMotions = 1e-14;

HandleConstraint translatedHandle(std::vector<Index> vertices, const Vector3& translate)
{
  return {{VertexIds{std::move(vertices)}}, {}, translate, {}};
}

Constraint named(const HandleConstraint& handle)
{
  return {"", true, handle};
}

Frame frame(const Vector3& origin, const Vector3& x, const Vector3& y)
{
  return {origin, x, y};
}

Positions randomPoints(test::Random& random, Index count, const Vector3& middle)
{
  Positions points(count, 3);
  for (Index k = 0; k < count; ++k) points.row(k) = (middle + test::randomVector(random, 2)).transpose();
  return points;
}

/// Returns where a motion takes points, far from anything fixed.
HandlePlacement placed(decltype(HandleConstraint::motion) motion, const Positions& rest,
                       const Vector3& translate = {0, 0, 0})
{
  HandleConstraint handle{{AllOf{}}, {}, translate, {}};
  handle.motion = std::move(motion);
  return placeHandle(handle, {rest, {std::nullopt, 10}, {"list", 0, "handle"}});
}

double largestDifference(const Positions& a, const Positions& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}

TEST(HandleTurn, KeepsTurnsBeyondTheFirst)
{
  test::Random random(1);
  const HandlePlacement placement =
      placed(AxisRotation{{0, 0, 3}, 450, std::nullopt}, randomPoints(random, 4, {1, 2, 3}));
  for (Index k = 0; k < 4; ++k) EXPECT_EQ(Vector3(placement.q.row(k)), Vector3(0, 0, 1.25 * pi));
}

TEST(HandleAboutFixed, TurnsAsItsCentroidDoesAboutTheFixedOne)
{
  Positions rest(2, 3);
  rest << 3, 1, 0, 5, -1, 0;  // centroid (4, 0, 0)
  HandleConstraint handle{{AllOf{}}, RotationAboutFixed{}, Vector3(-4, 4, 0), {}};
  const HandlePlacement placement = placeHandle(handle, {rest, {Vector3(0, 0, 0), 10}, {"list", 0, "handle"}});
  Positions expected(2, 3);
  expected << -1, 3, 0, 1, 5, 0;  // a quarter turn about z, then the centroid at (0, 4, 0)
  EXPECT_LT(largestDifference(placement.places, expected), kRoundingOfMotions);
  for (Index k = 0; k < 2; ++k)
    EXPECT_LT((Vector3(placement.q.row(k)) - Vector3(0, 0, pi / 4)).norm(), kRoundingOfMotions) << "half of 90 degrees";
}

TEST(HandleAboutFixed, TurnsByWhatIsNearestToTheTurnThatIsSaid)
{
  Positions rest(2, 3);
  rest << 3, 1, 0, 5, -1, 0;
  const HandleSurroundings surroundings{Vector3(0, 0, 0), 10};
  const HandleConstraint shortest{{AllOf{}}, RotationAboutFixed{}, Vector3(-4, 4, 0), {}};
  const Positions places = placeHandle(shortest, {rest, surroundings, {}}).places;
  for (const double turns : {-2, -1, 0, 1, 3}) {
    const double degrees = 90 + 360 * turns;
    HandleConstraint said = shortest;
    said.motion = RotationAboutFixed{AxisAngle{{0.2, 0, 1}, degrees + 100}};
    const HandlePlacement placement = placeHandle(said, {rest, surroundings, {}});
    EXPECT_EQ(placement.places, places) << "where it goes is the same";
    EXPECT_LT((Vector3(placement.q.row(0)) - Vector3(0, 0, degrees / 360 * pi)).norm(), kRoundingOfMotions) << degrees;
  }
}

TEST(HandleAboutFixed, IsToldTheAxisOfTheOppositeSide)
{
  Positions rest(2, 3);
  rest << 3, 1, 0, 5, -1, 0;
  for (const double degrees : {180.0, -180.0, 540.0}) {
    const HandleConstraint said{{AllOf{}}, RotationAboutFixed{AxisAngle{{0.5, 0, 2}, degrees}}, Vector3(-8, 0, 0), {}};
    const HandlePlacement placement = placeHandle(said, {rest, {Vector3(0, 0, 0), 10}, {}});
    Positions expected(2, 3);
    expected << -3, -1, 0, -5, 1, 0;
    EXPECT_LT(largestDifference(placement.places, expected), kRoundingOfMotions);
    EXPECT_LT((Vector3(placement.q.row(0)) - Vector3(0, 0, degrees / 360 * pi)).norm(), kRoundingOfMotions) << degrees;
  }
}

TEST(HandleAboutFixed, SeesTheCentroidOfAllVerticesThatAreFixed)
{
  const Mesh mesh = test::grid(4, 4);
  ConstraintList list = listOf({hold({0, 1}), hold({1, 2}), hold({24}), named(translatedHandle({14}, {-3, 1, 0}))});
  list.constraints[2].isEnabled = false;
  std::get<HandleConstraint>(list.constraints[3].what).motion = RotationAboutFixed{};
  const ConstraintSystem system = systemOf(mesh, list);
  // The fixed vertices are (0, 0), (1, 0) and (2, 0), each once. From their middle the handle goes from (3, 2) to
  // (0, 3).
  const double angle = pi / 2 - std::atan2(2, 3);
  ASSERT_EQ(system.rotations.size(), 4U);
  EXPECT_LT((system.rotations[3].q - Vector3(0, 0, angle / 2)).norm(), kRoundingOfMotions);
  EXPECT_LT((system.rows.back().target - Vector3(1, 3, 0)).norm(), kRoundingOfMotions);
}

TEST(HandleAboutFixed, DoesNotTurnOnItsWayOutOrAtRest)
{
  test::Random random(3);
  const Positions rest = randomPoints(random, 5, {1, 2, 3});
  const Vector3 centroid = rest.colwise().mean().transpose();
  for (const double share : {0.0, 0.5, 3.0}) {
    const HandleConstraint handle{{AllOf{}}, RotationAboutFixed{}, share * centroid, {}};
    const HandlePlacement placement = placeHandle(handle, {rest, {Vector3(0, 0, 0), 10}, {"list", 0, "handle"}});
    EXPECT_LT(placement.q.cwiseAbs().maxCoeff(), kRoundingOfMotions) << share;
    EXPECT_LT(largestDifference(placement.places, rest.rowwise() + share * centroid.transpose()), kRoundingOfMotions)
        << share;
  }
}

TEST(HandleFrame, IsTakenToTheOtherFrame)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Frame from = frame(test::randomVector(random, 3), test::randomVector(random, 2), Vector3(5, 0, 1));
    const Frame to = frame(test::randomVector(random, 3), test::randomVector(random, 2), Vector3(0, 4, 1));
    Positions rest(4, 3);
    rest.row(0) = from.origin->transpose();
    rest.bottomRows(3) = axesOf(from).transpose().rowwise() + from.origin->transpose();
    const HandlePlacement placement = placed(FrameMotion{from, to, 0}, rest);
    Positions expected(4, 3);
    expected.row(0) = to.origin->transpose();
    expected.bottomRows(3) = axesOf(to).transpose().rowwise() + to.origin->transpose();
    EXPECT_LT(largestDifference(placement.places, expected), kRoundingOfMotions);
    const Eigen::Matrix3d R = axesOf(to) * axesOf(from).transpose();
    EXPECT_LT((rotationMatrix(Vector3(placement.q.row(2))) - R).cwiseAbs().maxCoeff(), kRoundingOfMotions);
    EXPECT_LE(placement.q.row(0).norm(), pi / 2 + kRoundingOfMotions) << "the shortest way";
  }
}

TEST(HandleFrame, HasRightHandedAxesWhateverLengthsAndAnglesAreGiven)
{
  const Eigen::Matrix3d axes = axesOf(frame({9, 9, 9}, {0, 1e200, 0}, {-1e-200, 5e-200, 0}));
  Eigen::Matrix3d expected;
  expected << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_LT((axes - expected).cwiseAbs().maxCoeff(), kRoundingOfMotions);
}

TEST(HandleFrame, StandsAtTheCentroidAlongTheAxesWhereNothingElseIsSaid)
{
  Positions rest(2, 3);
  rest << 3, 1, 0, 5, -1, 0;
  FrameMotion motion;
  motion.to = Frame{std::nullopt, {0, 1, 0}, {-1, 0, 0}};
  Positions rotated(2, 3);
  rotated << 3, -1, 0, 5, 1, 0;
  EXPECT_EQ(placed(motion, rest).places, rotated) << "a quarter turn about (4, 0, 0), without rounding";
  motion.to.origin = Vector3(0, 0, 7);
  EXPECT_EQ(placed(motion, rest, {1, 0, 0}).places, rotated.rowwise() + Eigen::RowVector3d(-3, 0, 7))
      << "the centroid goes to the origin, and then by translate";
}

TEST(HandleFrame, TakesWholeTurnsMoreAboutTheSameAxis)
{
  test::Random random(4);
  const Positions rest = randomPoints(random, 3, {1, 2, 3});
  FrameMotion motion;
  motion.to = Frame{std::nullopt, {0, 1, 0}, {-1, 0, 0}};
  const HandlePlacement none = placed(motion, rest);
  for (const Index turns : {-2, -1, 1, 3}) {
    motion.turns = turns;
    const HandlePlacement some = placed(motion, rest);
    EXPECT_EQ(some.places, none.places);
    EXPECT_LT((Vector3(some.q.row(0)) - Vector3(0, 0, pi / 4 + pi * static_cast<double>(turns))).norm(),
              kRoundingOfMotions);
  }
}

TEST(HandleTargets, FindTheRotationThatWasPlanted)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Positions rest = randomPoints(random, 8, {1, 2, 3});
    const Vector3 q = test::randomVector(random, 0.8);
    const Vector3 away = test::randomVector(random, 5);
    VertexTargets targets;
    for (Index k = 0; k < rest.rows(); ++k)
      targets.places.emplace_back(rotationMatrix(q) * rest.row(k).transpose() + away);
    const HandlePlacement placement = placed(targets, rest);
    EXPECT_TRUE(placement.isDetermined);
    for (Index k = 0; k < rest.rows(); ++k) {
      EXPECT_EQ(Vector3(placement.places.row(k)), targets.places[k]) << "bit for bit";
      EXPECT_LT((Vector3(placement.q.row(k)) - q).norm(), kRoundingOfMotions);
    }
  }
}

TEST(HandleTargets, GoToTheVerticesInTheOrderOfTheirList)
{
  HandleConstraint moved = translatedHandle({8, 0, 2}, {0, 0, 0.5});
  moved.motion = VertexTargets{{{1, 0, 0}, {2, 0, 0}, {3, 1, 0}}};
  const ConstraintSystem system = systemOf(test::grid(2, 2), listOf({named(moved)}));
  ASSERT_EQ(system.rows.size(), 3U);
  EXPECT_EQ(system.rows[0].terms, (std::vector<Term>{{8, 1}}));
  EXPECT_EQ(system.rows[0].target, Vector3(1, 0, 0.5));
  EXPECT_EQ(system.rows[0].shift, Vector3(-1, -2, 0.5));
  EXPECT_EQ(system.rows[1].terms, (std::vector<Term>{{0, 1}}));
  EXPECT_EQ(system.rows[1].target, Vector3(2, 0, 0.5));
  EXPECT_EQ(system.rows[2].target, Vector3(3, 1, 0.5));
}

TEST(HandleTargets, OfWeldedVerticesThatDifferAreAskedForBoth)
{
  // The middle of the grid is vertex 2 of the first face and of others.
  const Mesh mesh = test::soup(test::grid(2, 2));
  std::vector<Index> middle;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (Vector3(mesh.positions.row(v)) == Vector3(1, 1, 0)) middle.push_back(v);
  HandleConstraint moved = translatedHandle({middle[0], middle[1], middle[2], middle[3]}, {0, 0, 0});
  moved.motion = VertexTargets{{{1, 1, 1}, {1, 1, 1}, {1, 1, 2}, {1, 1, 2}}};
  EXPECT_EQ(systemOf(mesh, listOf({named(moved)})).rows.size(), 2U);
}

TEST(HandleRotations, ReplaceTheRotationOfTheMotion)
{
  const std::vector<AxisAngle> turns{{{0, 0, 2}, 720}, {{1, 0, 0}, 0}, {{0, -1, 0}, 90}};
  const std::vector<Vector3> expected{{0, 0, 2 * pi}, {0, 0, 0}, {0, -pi / 4, 0}};
  for (const decltype(HandleConstraint::motion)& motion :
       {decltype(HandleConstraint::motion){},
        decltype(HandleConstraint::motion){AxisRotation{{1, 1, 1}, 30, std::nullopt}},
        decltype(HandleConstraint::motion){VertexTargets{{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}}}}) {
    HandleConstraint moved = translatedHandle({8, 0, 2}, {0, 0, 9});
    moved.motion = motion;
    const ConstraintSystem plain = systemOf(test::grid(2, 2), listOf({named(moved)}));
    moved.rotations = turns;
    const ConstraintSystem system = systemOf(test::grid(2, 2), listOf({hold({4}), named(moved)}));
    ASSERT_EQ(system.rotations.size(), 4U);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(system.rotations[k + 1].unknown, std::get<VertexIds>(moved.select.what).ids[k]);
      EXPECT_EQ(system.rotations[k + 1].q, expected[k]);
    }
    EXPECT_TRUE(system.notes.empty());
    for (const ConstraintRow& row : plain.rows)
      EXPECT_EQ(std::count_if(system.rows.begin(), system.rows.end(),
                              [&](const auto& r) { return r.terms == row.terms && r.target == row.target; }),
                1)
          << "it goes to the same places";
  }
}

std::string onlyNote(const ConstraintSystem& system, Index constraint, const std::string& kind)
{
  EXPECT_EQ(system.notes.size(), 1U);
  if (system.notes.size() != 1) return "";
  EXPECT_EQ(system.notes[0].constraint, constraint);
  EXPECT_EQ(system.notes[0].kind, kind);
  return system.notes[0].message;
}

TEST(ConstraintNotes, NameHandlesThatMoveFarWithoutTurning)
{
  const Mesh mesh = test::grid(4, 4);
  const auto system = [&](const HandleConstraint& moved) { return systemOf(mesh, listOf({hold({0}), named(moved)})); };
  const HandleConstraint far = translatedHandle({4}, {0, 0, 1.6});
  EXPECT_THAT(onlyNote(system(far), 1, "unsaid_rotation"),
              HasSubstr("moved 40 % of its distance to the fixed region without turning"));
  EXPECT_TRUE(system(translatedHandle({4}, {0, 0, 1})).notes.empty()) << "25 % is not much";
  EXPECT_FALSE(system(translatedHandle({4}, {0, 0, 1.01})).notes.empty()) << "but no more than that";
  HandleConstraint said = far;
  said.motion = AxisRotation{{0, 0, 1}, 0, std::nullopt};
  EXPECT_TRUE(system(said).notes.empty()) << "that it does not turn is said";
  said.motion = RotationAboutFixed{};
  EXPECT_TRUE(system(said).notes.empty());
  EXPECT_TRUE(systemOf(mesh, listOf({named(far)})).notes.empty()) << "there is nothing to turn about";
}

TEST(ConstraintNotes, NameTargetsThatDoNotSayHowTheHandleTurns)
{
  HandleConstraint moved = translatedHandle({0, 1, 2}, {0, 0, 0});
  moved.motion = VertexTargets{{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}};
  const ConstraintSystem system = systemOf(test::grid(2, 2), listOf({named(moved)}));
  EXPECT_THAT(onlyNote(system, 0, "undetermined_rotation"), HasSubstr("on a line"));
  EXPECT_LT((system.rotations[0].q - Vector3(0, 0, pi / 4)).norm(), kRoundingOfMotions) << "the shortest that fits";
}

TEST(ConstraintNotes, NameRigidRegionsOfOneVertex)
{
  const ConstraintSystem system =
      systemOf(test::grid(2, 2), listOf({hold({0}), {"", true, RigidConstraint{{VertexIds{{4}}}}}}));
  EXPECT_THAT(onlyNote(system, 1, "rigid_region_of_one_vertex"), HasSubstr("one vertex"));
}

TEST(ConstraintNotes, SayNothingOfDisabledConstraints)
{
  ConstraintList list =
      listOf({hold({0}), {"", true, RigidConstraint{{VertexIds{{4}}}}}, named(translatedHandle({8}, {0, 0, 9}))});
  EXPECT_EQ(systemOf(test::grid(2, 2), list).notes.size(), 2U);
  list.constraints[1].isEnabled = false;
  list.constraints[2].isEnabled = false;
  EXPECT_TRUE(systemOf(test::grid(2, 2), list).notes.empty());
}

}  // namespace
}  // namespace holdfast
