// What a deformation made of the part is said, and good results are called fine.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Report reportOf(const Mesh& mesh, const std::vector<Constraint>& constraints,
                RotationSource rotations = RotationSource::Given)
{
  DeformOptions options;
  options.rotations.source = rotations;
  return test::deformed(mesh, test::listOf(constraints), options).report;
}

const Finding& findingIn(const Report& report, const std::string& kind)
{
  static const Finding kMissing{};
  const Finding* finding = test::findingOf(report, kind);
  EXPECT_NE(finding, nullptr) << kind;
  return finding == nullptr ? kMissing : *finding;
}

/// The vertices on the border of a grid of squares.
std::vector<Index> rimOf(Index columns, Index rows)
{
  std::vector<Index> rim;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i)
      if (i == 0 || i == columns || j == 0 || j == rows) rim.push_back(j * (columns + 1) + i);
  return rim;
}

/// A point on each of the first `count` vertices, moved by `motion`.
std::vector<Constraint> pointsMovedBy(const Mesh& mesh, Index count, const Eigen::Affine3d& motion)
{
  std::vector<Constraint> points;
  for (Index v = 0; v < count; ++v)
    points.push_back(test::moveTo(AtVertex{v}, motion * mesh.positions.row(v).transpose()));
  return points;
}

Eigen::Affine3d rotationBy(double degrees)
{
  return Eigen::Affine3d(rotationMatrix(Vector3(1, 2, -1), degrees));
}

/// A plate of 10 x 4 squares whose left side is held and whose right side is lifted.
std::vector<Constraint> lifted(const Mesh& plate, double height)
{
  std::vector<Index> left;
  std::vector<Constraint> constraints;
  for (Index v = 0; v < plate.vertexCount(); ++v)
    if (plate.positions(v, 0) <= 1) left.push_back(v);
  constraints.push_back(test::hold(left));
  for (Index j = 0; j <= 4; j += 2) constraints.push_back(test::moveBy(AtVertex{j * 11 + 10}, Vector3(0, 0, height)));
  return constraints;
}

std::vector<Index> discOf(const Mesh& plate)
{
  std::vector<Index> disc;
  for (Index v = 0; v < plate.vertexCount(); ++v)
    if ((plate.positions.row(v) - Eigen::RowVector3d(5, 2, 0)).cwiseAbs().maxCoeff() <= 1) disc.push_back(v);
  return disc;
}

TEST(ResultVerdict, IsFineForSmoothDeformations)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const Report rest = reportOf(named.mesh, {test::hold({0, 1, 2})});
    EXPECT_EQ(rest.result.status, ResultStatus::Fine);
    EXPECT_EQ(rest.result.edges.most, 1);
    EXPECT_EQ(rest.result.crossingFaces, 0);
  }
}

TEST(ResultVerdict, IsNotMeasuredWhereNothingWasSolved)
{
  const Model model = makeModel(test::grid(2, 2), "mesh");
  EXPECT_EQ(diagnoseConstraints(model, test::listOf({test::hold({0})})).result.status, ResultStatus::NotMeasured);
}

TEST(ResultVerdict, OfAPointPulledOverTheHeldRimNamesTheInvertedFaces)
{
  for (const double pull : {2.5, 2.8, -2.5}) {
    SCOPED_TRACE(pull);
    const Report report =
        reportOf(test::grid(6, 6), {test::hold(rimOf(6, 6)), test::moveBy(AtVertex{24}, Vector3(pull, 0, 0))});
    EXPECT_EQ(report.result.status, ResultStatus::Doubtful);
    EXPECT_GT(report.result.foldedFaces, 0);
    EXPECT_EQ(findingIn(report, "inverted_faces").idsOf, "face");
    EXPECT_EQ(*report.result.invertedFaces, findingIn(report, "inverted_faces").count);
  }
}

TEST(ResultVerdict, OfTwoPointsInOneFaceNamesWhatStandsOutAndWhatHelps)
{
  const Mesh ball = test::icosphere(1);
  const Vector3 asked(0, 0, 1e-3);
  for (const double apart : {1e-4, 1e-3, 3e-3}) {
    SCOPED_TRACE(apart);
    const Report report = reportOf(ball, {test::hold({3, 9, 10}), test::moveBy(AtFace{0, {0.36, 0.32, 0.32}}, asked),
                                          test::moveBy(AtFace{0, {0.36 + apart, 0.32 - apart, 0.32}}, -asked)});
    EXPECT_EQ(report.result.status, ResultStatus::Doubtful);
    const Finding points = findingIn(report, "overshooting_points");
    EXPECT_THAT(points.ids, ElementsAre(1, 2));
    EXPECT_THAT(points.message, HasSubstr("leave some of them out"));
    EXPECT_THAT(points.message, HasSubstr("soft"));
    EXPECT_EQ(findingIn(report, "overshooting_vertices").idsOf, "vertex");
    EXPECT_GT(report.result.overshoot.largest, 4 * report.result.overshoot.asked);
  }
}

TEST(ResultVerdict, OvershootDoesNotDependOnAShiftOfTheWhole)
{
  const Mesh ball = test::icosphere(1);
  std::vector<Constraint> points = pointsMovedBy(ball, 0, rotationBy(0));
  const Vector3 far(100, 0, 0);
  for (const Index v : {3, 9, 10}) points.push_back(test::moveBy(AtVertex{v}, far));
  points.push_back(test::moveBy(AtFace{0, {0.36, 0.32, 0.32}}, far + Vector3(0, 0, 1e-3)));
  points.push_back(test::moveBy(AtFace{0, {0.3601, 0.3199, 0.32}}, far - Vector3(0, 0, 1e-3)));
  EXPECT_THAT(reportOf(ball, points).result.warnings, Contains("overshooting_points"));
}

TEST(ResultVerdict, APointThatIsPulledFarIsNoOvershoot)
{
  const Report report = reportOf(
      test::grid(8, 8), {test::hold(rimOf(8, 8)), test::moveBy(AtFace{72, {0.2, 0.3, 0.5}}, Vector3(0, 0, 6))});
  EXPECT_EQ(test::findingOf(report, "overshooting_points"), nullptr);
}

/// Faces of a sheet have two points each that follow a gentle shear, measured with noise.
TEST(ResultVerdict, OfDenseNoisyPointsIsDoubtful)
{
  const Mesh sheet = test::plate(12, 12);
  test::Random random(7);
  const auto shear = [](const Vector3& p) -> Vector3 { return {0, 0, 0.02 * p.x()}; };
  const auto measured = [&](double noise) {
    std::vector<Constraint> points;
    for (Index face = 0; face < sheet.faces.size(); face += 3)
      for (const std::vector<double>& weights : {std::vector{0.3, 0.3, 0.4}, std::vector{0.31, 0.3, 0.39}}) {
        Vector3 place = Vector3::Zero();
        for (std::size_t k = 0; k < 3; ++k) place += weights[k] * sheet.positions.row(sheet.faces[face][k]).transpose();
        points.push_back(test::moveTo(AtFace{face, weights}, place + shear(place) + test::randomVector(random, noise)));
      }
    return points;
  };
  const Report noisy = reportOf(sheet, measured(0.02));
  EXPECT_EQ(noisy.result.status, ResultStatus::Doubtful);
  EXPECT_THAT(noisy.result.warnings, Contains("overshooting_points"));
  EXPECT_THAT(reportOf(sheet, measured(0)).result.warnings, Not(Contains("overshooting_points")));
}

TEST(ResultVerdict, OfTargetsThatAreThePointsTurnedSaysTheAngle)
{
  const Mesh ball = test::icosphere(2);
  for (const double degrees : {10.0, 30.0, 110.0}) {
    SCOPED_TRACE(degrees);
    const std::vector<Constraint> points = pointsMovedBy(ball, 12, Eigen::Translation3d(3, 0, 0) * rotationBy(degrees));
    const Report report = reportOf(ball, points);
    EXPECT_THAT(findingIn(report, "turned_targets").message, HasSubstr("let rotations be found"));
    ASSERT_EQ(report.result.targetMotions.size(), 1U);
    EXPECT_NEAR(report.result.targetMotions[0].degrees, degrees, 1e-6);
    EXPECT_NEAR(report.result.targetMotions[0].axis.dot(Vector3(1, 2, -1).normalized()), 1, 1e-9);
    EXPECT_EQ(test::findingOf(reportOf(ball, points, RotationSource::Found), "turned_targets"), nullptr);
  }
}

TEST(ResultVerdict, OfTargetsThatAreScaledSaysTheFactor)
{
  const Mesh ball = test::icosphere(2);
  for (const double factor : {0.5, 2.0, 25.4}) {
    const Report report = reportOf(ball, pointsMovedBy(ball, 12, Eigen::Affine3d(Eigen::Scaling(factor))));
    EXPECT_EQ(findingIn(report, "scaled_targets").count, 12) << factor;
    ASSERT_EQ(report.result.targetMotions.size(), 1U);
    EXPECT_NEAR(report.result.targetMotions[0].scale, factor, 1e-9 * factor);
  }
}

TEST(ResultVerdict, OfTargetsThatAreShiftedWhileOthersHoldSaysSo)
{
  const Mesh ball = test::icosphere(2);
  std::vector<Constraint> points = pointsMovedBy(ball, 9, Eigen::Affine3d(Eigen::Translation3d(2, 0, 0)));
  EXPECT_THAT(reportOf(ball, points).result.warnings, IsEmpty()) << "the whole mesh goes there";
  points.push_back(test::hold({40, 41, 42}));
  EXPECT_EQ(findingIn(reportOf(ball, points), "shifted_targets").count, 9);
}

TEST(ResultVerdict, OfTargetsThatBendIsFine)
{
  const Mesh bar = test::transformed(test::box(Vector3(1, 1, 1), 8), Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, 6.0)));
  std::vector<Constraint> points;
  for (Index v = 0; v < bar.vertexCount(); v += 9) {
    const Vector3 p = bar.positions.row(v);
    points.push_back(test::moveBy(AtVertex{v}, Vector3(0.02 * p.z() * p.z(), 0, 0)));
  }
  EXPECT_THAT(reportOf(bar, points).result.warnings, IsEmpty());
}

TEST(ResultVerdict, OfSwappedTargetsNamesBothPoints)
{
  const Mesh plate = test::grid(10, 4);
  const auto place = [&](Index v) -> Vector3 { return plate.positions.row(v); };
  std::vector<Constraint> constraints = lifted(plate, 0.1);
  constraints.push_back(test::moveTo(AtVertex{15}, place(26) + Vector3(0, 0, 0.05)));
  constraints.push_back(test::moveTo(AtVertex{26}, place(15) + Vector3(0, 0, 0.05)));
  EXPECT_THAT(findingIn(reportOf(plate, constraints), "swapped_targets").ids, ElementsAre(4, 5));
  constraints[5] = test::moveTo(AtVertex{26}, place(26) + Vector3(0, 0, 0.05));
  EXPECT_EQ(test::findingOf(reportOf(plate, constraints), "swapped_targets"), nullptr);
}

TEST(ResultVerdict, OfAVectorThatIsReversedNamesIt)
{
  const Mesh plate = test::grid(10, 4);
  std::vector<Constraint> constraints = lifted(plate, 0.1);
  const Vector3 apart = (plate.positions.row(15) - plate.positions.row(26)).transpose();
  constraints.push_back({"pull", true, RelativeConstraint{AtVertex{15}, AtVertex{26}, -apart}});
  EXPECT_THAT(findingIn(reportOf(plate, constraints), "swapped_targets").ids, ElementsAre(4));
}

TEST(ResultVerdict, ARegionThatStaysLevelWhileItsSurroundingsTiltIsNamed)
{
  const Mesh plate = test::grid(10, 4);
  for (const double height : {4.0, 6.0, -5.0}) {
    SCOPED_TRACE(height);
    std::vector<Constraint> constraints = lifted(plate, height);
    constraints.push_back(test::rigid(discOf(plate)));
    EXPECT_THAT(findingIn(reportOf(plate, constraints), "level_regions").ids, ElementsAre(4));
    EXPECT_EQ(test::findingOf(reportOf(plate, constraints, RotationSource::Found), "level_regions"), nullptr);
  }
}

TEST(ResultVerdict, AHandleThatStaysLevelWhileItsSurroundingsTiltIsNamed)
{
  const Mesh plate = test::grid(10, 4);
  std::vector<Constraint> constraints = lifted(plate, 5);
  constraints.push_back(test::handle(discOf(plate), std::monostate(), Vector3(0, 0, 2)));
  const Report given = reportOf(plate, constraints);
  EXPECT_THAT(findingIn(given, "level_regions").ids, ElementsAre(4));
  EXPECT_THAT(findingIn(given, "level_regions").message, testing::HasSubstr("let rotations be found"));
  const Report found = reportOf(plate, constraints, RotationSource::Found);
  EXPECT_THAT(findingIn(found, "level_regions").message, testing::Not(testing::HasSubstr("let rotations be found")));
  constraints.back() = test::handle(discOf(plate), AxisRotation{Vector3::UnitY(), -25, {}}, Vector3(0, 0, 2));
  EXPECT_EQ(test::findingOf(reportOf(plate, constraints), "level_regions"), nullptr) << "it says how it turns";
}

TEST(ResultVerdict, ARegionThatPointsTurnAgainstItsSurroundingsIsNotLevel)
{
  const Mesh plate = test::grid(10, 4);
  std::vector<Constraint> constraints = lifted(plate, 0);
  const std::vector<Index> disc = discOf(plate);
  const Eigen::AngleAxisd turn(0.6, Vector3::UnitY());
  for (const std::size_t k : {std::size_t{0}, disc.size() / 2, disc.size() - 1}) {
    const Vector3 arm = (plate.positions.row(disc[k]) - plate.positions.row(disc[0])).transpose();
    constraints.push_back(test::moveTo(AtVertex{disc[k]}, plate.positions.row(disc[0]).transpose() + turn * arm));
  }
  constraints.push_back(test::rigid(disc));
  EXPECT_EQ(test::findingOf(reportOf(plate, constraints, RotationSource::Found), "level_regions"), nullptr);
  EXPECT_EQ(test::findingOf(reportOf(plate, constraints, RotationSource::FoundSmooth), "level_regions"), nullptr);
}

TEST(ResultVerdict, FramesLeaveOutWhatTakesLonger)
{
  const Model model = makeModel(test::grid(6, 6), "mesh");
  Deformer deformer(model);
  const ConstraintList list = test::listOf({test::hold(rimOf(6, 6)), test::moveBy(AtVertex{24}, Vector3(2.5, 0, 0))});
  const DeformResult frame = deformer.deform(list);
  EXPECT_EQ(frame.report.result.status, ResultStatus::NotMeasured);
  const Report checked = deformer.checked(frame);
  EXPECT_EQ(checked.result.status, ResultStatus::Doubtful);
  EXPECT_THAT(checked.result.warnings, Contains("folded_faces"));
  EXPECT_EQ(checked.result.invertedFaces, std::nullopt);
  const Report examined = deformer.examined(frame);
  EXPECT_THAT(examined.result.warnings, Contains("inverted_faces"));
  EXPECT_EQ(examined.result.warnings, deform(model, list).report.result.warnings);
}

TEST(ResultVerdict, IsTheSameForAMeshOfAnotherSize)
{
  for (const double size : {1e-60, 1.0, 1e60}) {
    const Mesh sheet = test::transformed(test::grid(6, 6), Eigen::Affine3d(Eigen::Scaling(size)));
    const Report report =
        reportOf(sheet, {test::hold(rimOf(6, 6)), test::moveBy(AtVertex{24}, Vector3(2.5 * size, 0, 0))});
    EXPECT_THAT(report.result.warnings,
                ElementsAre("folded_faces", "shortened_edges", "shrunk_faces", "inverted_faces"))
        << size;
  }
}

}  // namespace
}  // namespace holdfast
