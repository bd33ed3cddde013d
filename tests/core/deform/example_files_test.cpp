// What the constraint files in data/ that turn things promise, and what the planted conflicts come to.

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/deform.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/io/mesh_file.h>

#include "support/source_tree.h"

namespace holdfast {
namespace {

using testing::ElementsAre;

/// An example of data/, solved.
struct Example {
  Model model;
  ConstraintList list;
  DeformResult result;
};

DeformResult solved(const Model& model, const ConstraintList& list)
{
  NoProgress progress;
  return deform(model, list, "constraints", {}, progress);
}

Example example(const std::string& mesh, const std::string& constraints)
{
  Model model = makeModel(readMesh(test::dataFolder() + "/" + mesh).mesh, mesh);
  ConstraintList list = readConstraints(test::dataFolder() + "/" + constraints + ".constraints.json");
  DeformResult result = solved(model, list);
  return {std::move(model), std::move(list), std::move(result)};
}

void expectMet(const Example& solved)
{
  EXPECT_EQ(solved.result.report.solve.status, SolveStatus::Ok) << solved.result.report.solve.message;
  for (const Finding& finding : solved.result.report.mesh.findings)
    EXPECT_EQ(finding.kind, "boundary_loops") << finding.message;
  EXPECT_LE(solved.result.report.solve.maxResidualRelative, 1e-12);
}

Vector3 rowOf(const Columns3& columns, Index row)
{
  return columns.row(row).transpose();
}

// The bar stands on z = 0, is held up to z = 5, turned from z = 95 on, and has vertices at every whole z.

/// Returns the place along the free part of the bar, from 0 at the held end to 1 at the turned one.
double shareAt(int z)
{
  return std::clamp((z - 5) / 90.0, 0.0, 1.0);
}

/// By how much each section of the bar has turned about its length, counted on from the section below; degrees.
std::vector<double> sectionAngles(const Example& bar)
{
  std::vector<std::complex<double>> turns(101);
  for (Index v = 0; v < bar.model.mesh.vertexCount(); ++v) {
    const Vector3 rest = bar.model.mesh.positions.row(v);
    const Vector3 now = bar.result.positions.row(v);
    turns[std::lround(rest.z())] += std::complex(now.x(), now.y()) * std::complex(rest.x(), -rest.y());
  }
  std::vector<double> angles{0};
  for (std::size_t z = 1; z < turns.size(); ++z)
    angles.push_back(angles.back() + std::arg(turns[z] * std::conj(turns[z - 1])) * 180 / std::numbers::pi);
  return angles;
}

class TwistedBar : public testing::TestWithParam<int> {
 protected:
  double degrees_ = GetParam();
  Example bar_ = example("bar.obj", "bar.twist_" + std::to_string(GetParam()));
};
INSTANTIATE_TEST_SUITE_P(Examples, TwistedBar, testing::Values(90, 180, 360, 720));

TEST_P(TwistedBar, IsMet)
{
  expectMet(bar_);
}

// Along a prism the height is harmonic, and cotangents see that exactly.
TEST_P(TwistedBar, DetailTurnsInProportionToHeight)
{
  for (Index v = 0; v < bar_.model.mesh.vertexCount(); ++v) {
    const Vector3 q = rowOf(bar_.result.rotations, bar_.model.solverMesh.weld.unknownOf[v]);
    const int z = static_cast<int>(std::lround(bar_.model.mesh.positions(v, 2)));
    EXPECT_NEAR(360 / std::numbers::pi * q.z(), shareAt(z) * degrees_, 1e-12 * degrees_) << "vertex " << v;
    EXPECT_EQ(q.head<2>().norm(), 0);
  }
}

// Beside its ends, which are held over a length, the bar leaves them gently: shares are a little off a straight line.
TEST_P(TwistedBar, SectionsTurnMonotonicallyByTheirShares)
{
  constexpr double kOffAtEnds = 0.05;
  constexpr double kOffInTheMiddle = 0.005;
  const std::vector<double> angles = sectionAngles(bar_);
  for (int z = 0; z <= 100; ++z) {
    if (z > 5 && z <= 95) {
      EXPECT_GT(angles[z], angles[z - 1]) << z;
    }
    EXPECT_NEAR(angles[z] / degrees_, shareAt(z), z > 45 && z < 55 ? kOffInTheMiddle : kOffAtEnds) << z;
    EXPECT_NEAR(angles[z] + angles[100 - z], degrees_, 1e-9) << "both ends are alike, " << z;
  }
  EXPECT_NEAR(angles[100], degrees_, 1e-9);
}

/// The different logs that handles prescribe, in their order.
std::vector<Vector3> givenRotations(const DeformResult& result)
{
  std::map<Index, Vector3> ofConstraint;
  for (const GivenRotation& given : result.details->system.rotations) ofConstraint[given.constraint] = given.q;
  std::vector<Vector3> logs;
  logs.reserve(ofConstraint.size());
  for (const auto& [constraint, q] : ofConstraint) logs.push_back(q);
  return logs;
}

TEST(HandlesOfThePlate, TwoGiveRotationsOnTheSegmentBetweenThem)
{
  const Example plate = example("plate_unsymmetric.off", "plate_unsymmetric.two_handles");
  expectMet(plate);
  const std::vector<Vector3> ends = givenRotations(plate.result);
  ASSERT_EQ(ends.size(), 2U);
  const Vector3 along = ends[1] - ends[0];
  Index between = 0;
  for (Index u = 0; u < plate.result.rotations.rows(); ++u) {
    const Vector3 offset = rowOf(plate.result.rotations, u) - ends[0];
    const double share = offset.dot(along) / along.squaredNorm();
    EXPECT_GE(share, -1e-12) << u;
    EXPECT_LE(share, 1 + 1e-12) << u;
    EXPECT_LE((offset - share * along).norm(), 1e-12) << u;
    between += share > 0.3 && share < 0.7 ? 1 : 0;
  }
  EXPECT_GT(between, 100) << "rotations that are all at the ends would prove nothing";
}

TEST(HandlesOfThePlate, ThreeGiveRotationsInsideTheirTriangle)
{
  const Example plate = example("plate_unsymmetric.off", "plate_unsymmetric.three_handles");
  expectMet(plate);
  const std::vector<Vector3> corners = givenRotations(plate.result);
  ASSERT_EQ(corners.size(), 3U);
  const Vector3 a = corners[1] - corners[0];
  const Vector3 b = corners[2] - corners[0];
  const Vector3 normal = a.cross(b);
  Index inner = 0;
  for (Index u = 0; u < plate.result.rotations.rows(); ++u) {
    const Vector3 offset = rowOf(plate.result.rotations, u) - corners[0];
    const double s = offset.cross(b).dot(normal) / normal.squaredNorm();
    const double t = a.cross(offset).dot(normal) / normal.squaredNorm();
    EXPECT_GE(std::min({s, t, 1 - s - t}), -1e-12) << u;
    EXPECT_LE(std::abs(offset.dot(normal.normalized())), 1e-12) << u;
    inner += std::min({s, t, 1 - s - t}) > 0.1 ? 1 : 0;
  }
  EXPECT_GT(inner, 100) << "rotations that are all on the sides would prove nothing";
}

class LeaningHead : public testing::Test {
 protected:
  /// The largest change of a distance between two vertices of one rigid region, in diagonals.
  [[nodiscard]] double stretch(const Positions& positions) const
  {
    const Positions& rest = head_.model.mesh.positions;
    double largest = 0;
    for (const auto& group : head_.result.details->system.rigidRegions)
      for (const Index i : group)
        for (const Index j : group)
          largest = std::max(
              largest, std::abs((positions.row(i) - positions.row(j)).norm() - (rest.row(i) - rest.row(j)).norm()));
    return largest / head_.model.solverMesh.diagonal;
  }

  Example head_ = example("head.ply", "head.rigid_eyes");
};

TEST_F(LeaningHead, IsMet)
{
  expectMet(head_);
}

TEST_F(LeaningHead, KeepsEveryDistanceWithinItsEyes)
{
  ASSERT_EQ(head_.result.details->system.rigidRegions.size(), 2U);
  ASSERT_EQ(head_.model.solverMesh.unknownCount(), head_.model.mesh.vertexCount());
  for (const auto& group : head_.result.details->system.rigidRegions) EXPECT_GT(group.size(), 50U);
  EXPECT_LE(stretch(head_.result.positions), 1e-12);
}

TEST_F(LeaningHead, WouldDeformItsEyesIfTheyWereNotRigid)
{
  ConstraintList soft = head_.list;
  for (Constraint& constraint : soft.constraints)
    if (std::holds_alternative<RigidConstraint>(constraint.what)) constraint.isEnabled = false;
  EXPECT_GT(stretch(solved(head_.model, soft).positions), 1e-3);
}

TEST_F(LeaningHead, TurnsTheVectorFromMouthToNoseAndKeepsItsLength)
{
  ASSERT_GE(head_.result.details->system.rotated.size(), 1U);
  const RotatedVector& rotated = head_.result.details->system.rotated.back();
  Vector3 vector = Vector3::Zero();
  Vector3 rest = Vector3::Zero();
  for (const Term& term : head_.result.details->system.rows[rotated.row].terms) {
    vector += term.coefficient * head_.result.positions.row(term.index).transpose();
    rest += term.coefficient * head_.model.mesh.positions.row(term.index).transpose();
  }
  Vector3 q = Vector3::Zero();
  for (const Term& term : rotated.rotation) q += term.coefficient * rowOf(head_.result.rotations, term.index);
  const double diagonal = head_.model.solverMesh.diagonal;
  EXPECT_GT(rest.norm(), 20);
  EXPECT_GT(angleDegrees(q), 5);
  EXPECT_LE(std::abs(vector.norm() - rest.norm()), 1e-12 * diagonal);
  EXPECT_LE((vector - rotationExp(q) * rest).norm(), 1e-12 * diagonal);
}

class PlantedConflicts : public testing::Test {
 protected:
  [[nodiscard]] const ConstraintOutcome& outcome(const std::string& beginning) const
  {
    const auto& all = plate_.result.report.constraints;
    return *std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name.starts_with(beginning); });
  }

  /// The only way in which a constraint clashes.
  [[nodiscard]] ConflictSet conflictSet(const std::string& beginning) const
  {
    EXPECT_EQ(outcome(beginning).conflictSets.size(), 1U) << beginning;
    return outcome(beginning).conflictSets.front();
  }

  void expectConflict(const std::string& beginning, const std::vector<std::string>& with, const Vector3& gap) const
  {
    SCOPED_TRACE(beginning);
    const ConflictSet found = conflictSet(beginning);
    EXPECT_TRUE(found.isConflict);
    EXPECT_EQ(found.with, with);
    EXPECT_LE((found.gap - gap).norm(), 1e-12 * plate_.model.solverMesh.diagonal) << found.gap.transpose();
  }

  void expectRepetition(const std::string& beginning, const std::vector<std::string>& with) const
  {
    SCOPED_TRACE(beginning);
    const ConflictSet found = conflictSet(beginning);
    EXPECT_FALSE(found.isConflict);
    EXPECT_EQ(found.with, with);
  }

  Example plate_ = example("plate_unsymmetric.off", "plate_unsymmetric.conflict");
};

TEST_F(PlantedConflicts, AreExactlyThoseNamed)
{
  EXPECT_EQ(plate_.result.report.solve.status, SolveStatus::Conflicts);
  EXPECT_LE(plate_.result.report.solve.maxResidualRelative, 1e-12);
  for (const ConstraintOutcome& one : plate_.result.report.constraints) {
    const bool isConflict = one.name.ends_with("(conflicting)");
    const bool isRepetition = one.name.ends_with("(redundant)");
    const auto expected = isConflict     ? ConstraintStatus::Conflicting
                          : isRepetition ? ConstraintStatus::Redundant
                                         : ConstraintStatus::Met;
    EXPECT_EQ(one.status, expected) << one.name;
    EXPECT_EQ(one.conflictSets.empty(), !isConflict && !isRepetition) << one.name;
  }
}

TEST_F(PlantedConflicts, HaveThePartnersAndTheGapsOfTheTable)
{
  expectRepetition("badge corner 2", {"badge", "badge corner 1"});
  expectConflict("badge corner 3", {"badge", "badge corner 1"}, {0, 0, 2});
  expectConflict("lift beside it", {"lift"}, {0, 0, 0.5});
  expectRepetition("seam, from the other face (", {"seam"});
  expectConflict("seam, from the other face, 0.25 aside", {"seam"}, {0.25, 0, 0});
  expectRepetition("loop 3, which closes it", {"loop 1", "loop 2"});
  expectConflict("loop 3 by 1.5 more", {"loop 1", "loop 2"}, {0, 0, 1.5});
}

TEST_F(PlantedConflicts, AreTheSameWhereNothingIsSolved)
{
  const Report report = diagnoseConstraints(plate_.model, plate_.list, "constraints");
  ASSERT_EQ(report.constraints.size(), plate_.result.report.constraints.size());
  for (std::size_t c = 0; c < report.constraints.size(); ++c) {
    const ConstraintStatus status = plate_.result.report.constraints[c].status;
    EXPECT_EQ(report.constraints[c].status, status == ConstraintStatus::Met ? ConstraintStatus::Independent : status);
  }
}

TEST_F(PlantedConflicts, AreGoneOnceWhatTheyNameIsDisabled)
{
  ConstraintList repaired = plate_.list;
  for (const ConstraintOutcome& one : plate_.result.report.constraints)
    for (const ConflictSet& found : one.conflictSets)
      for (Constraint& constraint : repaired.constraints)
        if (found.isConflict && constraint.name == found.disable) constraint.isEnabled = false;
  const DeformResult result = solved(plate_.model, repaired);
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
}

}  // namespace
}  // namespace holdfast
