// Where rotations are found, a rigid region is one rigid body whose rotation the points in it decide. A conflict is
// only what no rigid motion meets.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/deform/deformer.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/rotation/rotation_energy.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::ElementsAre;

constexpr RotationSource kSourcesThatFind[] = {RotationSource::Found, RotationSource::FoundSmooth};

DeformOptions foundBy(RotationSource source)
{
  return {Weights::Cotangent, {}, {source, kFoundChange, kMostIterations}};
}

/// A sheet of 8 x 8 squares whose border is held. The pad in its middle has the corners 30, 33, 57, 60.
constexpr Index kSheet = 8;
Mesh sheet()
{
  return test::grid(kSheet, kSheet);
}

std::vector<Index> rim()
{
  std::vector<Index> ids;
  for (Index v = 0; v < (kSheet + 1) * (kSheet + 1); ++v) {
    const Index i = v % (kSheet + 1);
    const Index j = v / (kSheet + 1);
    if (i == 0 || j == 0 || i == kSheet || j == kSheet) ids.push_back(v);
  }
  return ids;
}

/// The vertices (i, j) with 3 <= i, j <= 6.
std::vector<Index> pad()
{
  std::vector<Index> ids;
  for (Index j = 3; j <= 6; ++j)
    for (Index i = 3; i <= 6; ++i) ids.push_back(j * (kSheet + 1) + i);
  return ids;
}

Constraint called(std::string name, Constraint constraint)
{
  constraint.name = std::move(name);
  return constraint;
}

/// A rigid motion of the pad.
struct PadMotion {
  Eigen::Matrix3d R;
  Vector3 shift;

  [[nodiscard]] Vector3 operator()(const Vector3& p) const
  {
    return R * (p - Vector3(3, 3, 0)) + Vector3(3, 3, 0) + shift;
  }
  [[nodiscard]] Vector3 operator()(const Mesh& mesh, Index v) const { return (*this)(Vector3(mesh.positions.row(v))); }
};

PadMotion tilt(double degrees, const Vector3& axis = {0.3, 1, 0.2})
{
  return {rotationMatrix(axis, degrees), Vector3(0.1, 0.2, 0.4)};
}

ConstraintList onSheet(std::vector<Constraint> constraints)
{
  constraints.insert(constraints.begin(), called("rim", test::hold(rim())));
  return {"", std::move(constraints)};
}

Constraint pinned(const Mesh& mesh, const std::string& name, Index v, const PadMotion& motion)
{
  return called(name, test::moveTo(AtVertex{v}, motion(mesh, v)));
}

void expectPadMoved(const Mesh& mesh, const DeformResult& result, const PadMotion& motion)
{
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, kPromisedResidual);
  for (const Index v : pad())
    EXPECT_LT((Vector3(result.positions.row(v)) - motion(mesh, v)).norm(), 1e-11) << "vertex " << v;
}

void expectPadRigid(const Mesh& mesh, const Positions& positions)
{
  for (const Index a : pad())
    for (const Index b : pad())
      EXPECT_NEAR((positions.row(a) - positions.row(b)).norm(), (mesh.positions.row(a) - mesh.positions.row(b)).norm(),
                  1e-11);
}

std::string nameOf(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names) text += name + " ";
  return text;
}

TEST(RigidBodies, TurnAsThreePointsInThemSay)
{
  const Mesh mesh = sheet();
  for (const RotationSource source : kSourcesThatFind)
    for (const double degrees : {5.0, 37.0, 120.0, 179.0}) {
      SCOPED_TRACE(testing::Message() << name(source) << ", " << degrees);
      const PadMotion motion = tilt(degrees);
      const ConstraintList list = onSheet({called("pad", test::rigid(pad())), pinned(mesh, "A", 30, motion),
                                           pinned(mesh, "B", 33, motion), pinned(mesh, "C", 57, motion)});
      expectPadMoved(mesh, test::deformed(mesh, list, foundBy(source)), motion);
    }
}

TEST(RigidBodies, TurnAsPointsOnFacesAndEdgesSayInAnyOrder)
{
  const Mesh mesh = sheet();
  const PadMotion motion = tilt(50);
  const auto on = [&](const std::string& name, const Vector3& place) {
    return called(name, test::moveTo(AtNear{place}, motion(place)));
  };
  std::vector<Constraint> points{on("A", {3.25, 3.5, 0}), on("B", {5.5, 4, 0}), on("C", {4.5, 5.75, 0}),
                                 on("D", {3.5, 5, 0})};
  points.insert(points.begin() + 2, called("pad", test::rigid(pad())));
  expectPadMoved(mesh, test::deformed(mesh, onSheet(points), foundBy(RotationSource::Found)), motion);
}

TEST(RigidBodies, TurnAsAHandleInThemThatOnlyMovesOrTurns)
{
  const Mesh mesh = sheet();
  const PadMotion moved{Eigen::Matrix3d::Identity(), Vector3(0.2, -0.1, 0.7)};
  const ConstraintList shifted = onSheet(
      {called("pad", test::rigid(pad())), called("H", test::handle({30, 31, 39, 40}, std::monostate{}, moved.shift))});
  expectPadMoved(mesh, test::deformed(mesh, shifted, foundBy(RotationSource::Found)), moved);
  const ConstraintList tilted = onSheet(
      {called("H", test::handle({30, 31, 39}, AxisRotation{{0, 1, 0}, 40, Vector3(3, 3, 0)}, Vector3(0, 0, 0.3))),
       called("pad", test::rigid(pad()))});
  const PadMotion about{rotationMatrix({0, 1, 0}, 40), Vector3(0, 0, 0.3)};
  const DeformResult result = test::deformed(mesh, tilted, foundBy(RotationSource::Found));
  expectPadMoved(mesh, result, about);
  EXPECT_EQ(test::findingOf(result.report, "rotations_overruled"), nullptr);
}

TEST(RigidBodies, TurnAboutTheLineOfTheirPointsByTheLeastEnergy)
{
  const Mesh mesh = sheet();
  const PadMotion motion = tilt(30, {0, 1, 0});
  for (const RotationSource source : kSourcesThatFind) {
    const ConstraintList two =
        onSheet({called("pad", test::rigid(pad())), pinned(mesh, "A", 30, motion), pinned(mesh, "B", 57, motion)});
    const ConstraintList three = onSheet({called("pad", test::rigid(pad())), pinned(mesh, "A", 30, motion),
                                          pinned(mesh, "B", 57, motion), pinned(mesh, "M", 39, motion)});
    const DeformResult result = test::deformed(mesh, two, foundBy(source));
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    expectPadRigid(mesh, result.positions);
    const DeformResult onLine = test::deformed(mesh, three, foundBy(source));
    EXPECT_EQ(onLine.report.solve.status, SolveStatus::Ok) << "a third point on the line says nothing new";
    EXPECT_LE(test::distance(onLine.positions, result.positions), 1e-6);
  }
}

TEST(RigidBodies, KeepEnergyFromRisingAboutTheirPoints)
{
  const Mesh mesh = sheet();
  const Model model = makeModel(mesh);
  const PadMotion motion = tilt(25);
  std::vector<Constraint> points{called("pad", test::rigid(pad()))};
  for (const Index corner : {30, 33}) {
    points.push_back(pinned(mesh, std::to_string(corner), corner, motion));
    const RotationEnergy energy(model.solverMesh, makeOperators(model.solverMesh, Weights::Cotangent),
                                RotationSource::Found);
    double last = std::numeric_limits<double>::infinity();
    for (int count = 1; count <= 12; ++count) {
      DeformOptions options = foundBy(RotationSource::Found);
      options.rotations.mostIterations = count;
      const DeformResult result = deform(model, onSheet(points), "constraints", options);
      UnknownRotations R;
      for (Index i = 0; i < result.rotations.rows(); ++i) R.push_back(rotationExp(Vector3(result.rotations.row(i))));
      const double value = energy.value(result.positions - mesh.positions, R);
      EXPECT_LE(value, last * (1 + 1e-12)) << points.size() << " " << count;
      last = value;
    }
  }
}

TEST(RigidBodies, ConflictWithDistancesThatDifferByTheirGap)
{
  const Mesh mesh = sheet();
  const PadMotion motion = tilt(40);
  const Vector3 direction = (motion(mesh, 33) - motion(mesh, 30)).normalized();
  Constraint b = pinned(mesh, "B", 33, motion);
  std::get<Target>(std::get<PointConstraint>(b.what).to).place += 0.5 * direction;
  const ConstraintList list =
      onSheet({called("pad", test::rigid(pad())), pinned(mesh, "A", 30, motion), b, pinned(mesh, "C", 57, motion)});
  const DeformResult result = test::deformed(mesh, list, foundBy(RotationSource::Found));
  EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts);
  const ConstraintOutcome& outcome = result.report.constraints[3];
  EXPECT_EQ(outcome.status, ConstraintStatus::Conflicting);
  ASSERT_EQ(outcome.conflictSets.size(), 1U);
  EXPECT_THAT(outcome.conflictSets[0].with, ElementsAre("pad", "A"));
  EXPECT_NEAR(outcome.conflictSets[0].gap.norm(), 0.5, 1e-9);
  EXPECT_EQ(result.report.constraints[4].status, ConstraintStatus::Redundant) << "C is as far from A as at rest";
  EXPECT_LT((*outcome.conflictSets[0].consistentTarget - motion(mesh, 33)).norm(), 1e-9);
  expectPadRigid(mesh, result.positions);
}

TEST(RigidBodies, NameTheEarlierPointThatLiesTooFar)
{
  const Mesh mesh = sheet();
  const PadMotion motion = tilt(40);
  // It is as far from A as at rest, and tilted about A: so it is B that it lies wrong to.
  const PadMotion other{motion.R * rotationMatrix({0, 0, 1}, 20), motion.shift};
  const ConstraintList list =
      onSheet({called("pad", test::rigid(pad())), pinned(mesh, "A", 30, motion), pinned(mesh, "B", 33, motion),
               pinned(mesh, "C", 57, motion), pinned(mesh, "D", 60, other)});
  const DeformResult result = test::deformed(mesh, list, foundBy(RotationSource::Found));
  const ConstraintOutcome& outcome = result.report.constraints[5];
  ASSERT_EQ(outcome.conflictSets.size(), 1U);
  EXPECT_THAT(outcome.conflictSets[0].with, ElementsAre("pad", "B")) << nameOf(outcome.conflictSets[0].with);
  EXPECT_NEAR(outcome.conflictSets[0].gap.norm(), (other(mesh, 60) - motion(mesh, 60)).norm(), 1e-9);
}

TEST(RigidBodies, ThatAreMirroredConflictWithAllPointsThatSayHow)
{
  // A corner of a box: four points that are no plane, all distances right, mirrored.
  const Mesh mesh = test::box(Vector3(2, 2, 2), 2);
  std::vector<Index> all;
  for (Index v = 0; v < mesh.vertexCount(); ++v) all.push_back(v);
  const auto at = [&](const Vector3& place) {
    for (const Index v : all)
      if ((Vector3(mesh.positions.row(v)) - place).norm() < 1e-12) return v;
    return Index(-1);
  };
  const auto mirroredPoint = [&](const std::string& name, const Vector3& place) {
    return called(name, test::moveTo(AtVertex{at(place)}, Vector3(place.x(), place.y(), -place.z())));
  };
  const ConstraintList list{
      "",
      {called("body", test::rigid(all)), mirroredPoint("O", {0, 0, 0}), mirroredPoint("X", {2, 0, 0}),
       mirroredPoint("Y", {0, 2, 0}), mirroredPoint("Z", {0, 0, 2})}};
  const DeformResult result = test::deformed(mesh, list, foundBy(RotationSource::Found));
  const ConstraintOutcome& outcome = result.report.constraints[4];
  ASSERT_EQ(outcome.conflictSets.size(), 1U);
  EXPECT_THAT(outcome.conflictSets[0].with, ElementsAre("body", "O", "X", "Y"));
  EXPECT_NEAR(outcome.conflictSets[0].gap.norm(), 4, 1e-9);
}

TEST(RigidBodies, AreSaidToBeMetByFoundRotationsWhereRotationsAreGiven)
{
  const Mesh mesh = sheet();
  const PadMotion motion = tilt(40);
  ConstraintList list = onSheet({called("pad", test::rigid(pad())), pinned(mesh, "A", 30, motion),
                                 pinned(mesh, "B", 33, motion), pinned(mesh, "C", 57, motion)});
  std::get<Target>(std::get<PointConstraint>(list.constraints[4].what).to).place.x() += 3;
  for (const Report& report : {test::deformed(mesh, list, {}).report, diagnoseConstraints(makeModel(mesh), list)}) {
    ASSERT_EQ(report.constraints[3].conflictSets.size(), 1U);
    EXPECT_TRUE(report.constraints[3].conflictSets[0].isMetByFoundRotations);
    ASSERT_EQ(report.constraints[4].conflictSets.size(), 1U);
    EXPECT_FALSE(report.constraints[4].conflictSets[0].isMetByFoundRotations) << "no rotation meets it";
  }
  const Report found = diagnoseConstraints(makeModel(mesh), list, "list", foundBy(RotationSource::Found));
  EXPECT_EQ(found.constraints[3].status, ConstraintStatus::Redundant);
  EXPECT_EQ(found.constraints[4].status, ConstraintStatus::Conflicting);
}

TEST(RigidBodies, ThatShareVerticesTurnAsOne)
{
  const Mesh mesh = sheet();
  const PadMotion motion = tilt(60);
  std::vector<Index> halves[2];
  for (const Index v : pad()) {
    if (mesh.positions(v, 0) <= 4) halves[0].push_back(v);
    if (mesh.positions(v, 0) >= 4) halves[1].push_back(v);
  }
  const ConstraintList list =
      onSheet({called("left", test::rigid(halves[0])), pinned(mesh, "A", 30, motion), pinned(mesh, "B", 57, motion),
               called("right", test::rigid(halves[1])), pinned(mesh, "C", 60, motion)});
  expectPadMoved(mesh, test::deformed(mesh, list, foundBy(RotationSource::Found)), motion);
}

TEST(RigidBodies, ThatAreFixedInOnePlaceTurnAboutItWhereAPointAsksForThat)
{
  const Mesh mesh = sheet();
  const PadMotion motion{rotationMatrix({0, 1, 0}, -30), Vector3::Zero()};
  const ConstraintList list = onSheet({called("corner", test::hold({30})), called("pad", test::rigid(pad())),
                                       pinned(mesh, "B", 33, motion), pinned(mesh, "C", 57, motion)});
  const DeformResult result = test::deformed(mesh, list, foundBy(RotationSource::Found));
  expectPadMoved(mesh, result, motion);
  const Finding* const finding = test::findingOf(result.report, "rotations_overruled");
  ASSERT_NE(finding, nullptr);
  EXPECT_THAT(finding->ids, ElementsAre(1));
}

TEST(RigidBodies, TurnWithARelativeConstraintBetweenTwoOfTheirPoints)
{
  const Mesh mesh = sheet();
  const Vector3 offset = rotationMatrix({0, 1, 0}, 35) * Vector3(3, 0, 0);
  const Constraint relative{"lean", true, RelativeConstraint{AtVertex{33}, AtVertex{30}, offset}};
  const DeformResult result =
      test::deformed(mesh, onSheet({called("pad", test::rigid(pad())), relative}), foundBy(RotationSource::Found));
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LT((Vector3(result.positions.row(33) - result.positions.row(30)) - offset).norm(), 1e-11);
  expectPadRigid(mesh, result.positions);
}

TEST(RigidBodies, ThatAreTiedToOneAnotherTurnTogether)
{
  // Two strips, each held at one end, whose other ends are to meet: both swing.
  const Mesh mesh = test::grid(10, 4);
  const auto column = [&](Index low, Index high) {
    std::vector<Index> ids;
    for (Index j = 1; j <= 3; ++j)
      for (Index i = low; i <= high; ++i) ids.push_back(j * 11 + i);
    return ids;
  };
  const Constraint tie{"tie", true, RelativeConstraint{AtVertex{2 * 11 + 4}, AtVertex{2 * 11 + 6}, Vector3(-1, 0, 0)}};
  const ConstraintList list{"",
                            {called("left", test::rigid(column(1, 4))), called("right", test::rigid(column(6, 9))),
                             called("A", test::moveBy(AtVertex{2 * 11 + 1}, Vector3(0.2, 0, 0))),
                             called("B", test::moveBy(AtVertex{2 * 11 + 9}, Vector3(-1.5, 0, 0.5))), tie}};
  DeformOptions options = foundBy(RotationSource::Found);
  options.rotations.mostIterations = 20;  // constraints hold in each
  const DeformResult result = test::deformed(mesh, list, options);
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, kPromisedResidual);
}

TEST(KeptVectors, BetweenHeldPointsTurnAsTheseSay)
{
  const Mesh mesh = sheet();
  const Vector3 rest(3, 0, 0);
  const Vector3 tilted = rotationMatrix({0, 1, 0.5}, 25) * rest;
  const auto list = [&](const Vector3& between) {
    return onSheet({called("A", test::moveTo(AtVertex{30}, Vector3(3, 3, 0.5))),
                    called("B", test::moveTo(AtVertex{33}, Vector3(3, 3, 0.5) + between)),
                    Constraint{"kept", true, RelativeConstraint{AtVertex{33}, AtVertex{30}, std::nullopt}}});
  };
  const DeformResult result = test::deformed(mesh, list(tilted), foundBy(RotationSource::Found));
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  const DeformResult longer = test::deformed(mesh, list(1.2 * tilted), foundBy(RotationSource::Found));
  EXPECT_EQ(longer.report.solve.status, SolveStatus::Conflicts);
  EXPECT_NEAR(longer.report.constraints[3].conflictSets.at(0).gap.norm(), 0.6, 1e-9) << "by how much it is longer";
}

TEST(RigidBodies, TurnInTheFramesOfADragAsInAFreshDeformation)
{
  const Mesh mesh = sheet();
  Deformer deformer(makeModel(mesh), foundBy(RotationSource::Found));
  for (const double degrees : {5.0, 15.0, 30.0, 60.0, 100.0}) {
    const PadMotion motion = tilt(degrees);
    const ConstraintList list = onSheet({called("pad", test::rigid(pad())), pinned(mesh, "A", 30, motion),
                                         pinned(mesh, "B", 33, motion), pinned(mesh, "C", 57, motion)});
    expectPadMoved(mesh, deformer.deformFrame(list), motion);
  }
}

}  // namespace
}  // namespace holdfast
