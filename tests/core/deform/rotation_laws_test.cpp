
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/dense_operators.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

const Vector3 kAxis(1, 2, 3);
constexpr double kExact = 1e-12;

Constraint turn(std::string name, std::vector<Index> vertices, double degrees, const Vector3& translate)
{
  HandleConstraint handle;
  handle.select = {VertexIds{std::move(vertices)}};
  handle.motion = AxisRotation{kAxis, degrees, Vector3(0.1, 0.2, 0.3)};
  handle.translate = translate;
  return {std::move(name), true, handle};
}

/// The vertices of `mesh` whose place along x is in the given share of its extent.
std::vector<Index> between(const Mesh& mesh, double from, double to)
{
  const double low = mesh.positions.col(0).minCoeff();
  const double size = mesh.positions.col(0).maxCoeff() - low;
  std::vector<Index> ids;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (const double share = (mesh.positions(v, 0) - low) / size; share >= from && share <= to) ids.push_back(v);
  return ids;
}

TEST(RotationLaws, ACommonRotationOfAllHandlesTurnsTheMeshRigidly)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    const Index n = mesh.vertexCount();
    const Vector3 shift(0.3, -0.2, 0.5);
    // Handles on every part; the last point is left to the surface.
    std::vector<Index> some;
    for (Index v = 0; v < n; v += 3) some.push_back(v);
    for (const double degrees : {10.0, 120.0, 250.0}) {
      const ConstraintList list{"",
                                {turn("a", {some.begin(), some.begin() + 3}, degrees, shift),
                                 turn("b", {some.begin() + 3, some.end()}, degrees, shift)}};
      const DeformResult result = test::deformed(mesh, list, options);
      ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
      const Eigen::Matrix3d R = rotationMatrix(kAxis, degrees);
      const Vector3 center(0.1, 0.2, 0.3);
      Positions expected = mesh.positions;
      for (Index v = 0; v < n; ++v) expected.row(v) = R * (mesh.positions.row(v).transpose() - center) + center + shift;
      EXPECT_LT(test::distance(result.positions, expected), kExact) << degrees;
    }
  });
}

TEST(RotationLaws, NothingTurnsWhereNoRotationIsGiven)
{
  const Mesh mesh = test::plate(6, 5);
  ConstraintList list = test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{20}, {0, 0, 1})});
  const DeformResult result = test::deformed(mesh, list, {});
  EXPECT_TRUE(result.rotations.isZero(0));
  ConstraintList rotated = list;
  rotated.constraints.push_back(turn("turned", {30, 31}, 40, Vector3::Zero()));
  EXPECT_FALSE(test::deformed(mesh, rotated, {}).rotations.isZero(1e-3)) << "a turned handle turns others";
}

TEST(RotationLaws, RotationsOfOneHandleLieOnTheShortestArc)
{
  const Mesh mesh = test::plate(12, 4);
  const ConstraintList list{
      "", {test::hold(between(mesh, 0, 0.1)), turn("end", between(mesh, 0.9, 1), 170, Vector3(0, 0, 1))}};
  for (const Weights weights : {Weights::Cotangent, Weights::Uniform}) {
    const DeformResult result = test::deformed(mesh, list, {weights, {}});
    const Vector3 r = rotationLog(kAxis, 170);
    for (Index u = 0; u < result.rotations.rows(); ++u) {
      const Vector3 q = result.rotations.row(u).transpose();
      EXPECT_LT(q.cross(r.normalized()).norm(), kExact);
      EXPECT_GE(q.dot(r), -kExact);
      EXPECT_LE(q.dot(r), r.squaredNorm() + kExact);
    }
  }
}

TEST(RotationLaws, ATwistedBarTurnsSectionBySection)
{
  const Mesh bar = test::transformed(test::box(Vector3(1, 1, 1), 10), Eigen::Affine3d(Eigen::Scaling(10.0, 1.0, 1.0)));
  for (const double degrees : {90.0, 360.0, 720.0}) {
    Constraint end = turn("end", between(bar, 0.999, 1), degrees, Vector3::Zero());
    std::get<HandleConstraint>(end.what).motion = AxisRotation{Vector3::UnitX(), degrees, Vector3(5, 0.5, 0.5)};
    const DeformResult result = test::deformed(bar, {"", {test::hold(between(bar, 0, 0.001)), end}}, {});
    ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    double last = -1;
    for (int section = 0; section <= 10; ++section) {
      const std::vector<Index> ids = between(bar, section / 10.0 - 1e-6, section / 10.0 + 1e-6);
      double mean = 0;
      for (const Index v : ids) mean += angleDegrees(result.rotations.row(v).transpose()) / double(ids.size());
      EXPECT_GT(mean, last);
      EXPECT_NEAR(mean / degrees, section / 10.0, 0.06) << section;
      last = mean;
    }
    EXPECT_NEAR(last, degrees, 1e-9);
  }
}

double largestChangeOfDistance(const Positions& before, const Positions& after, const std::vector<Index>& ids)
{
  double largest = 0;
  for (std::size_t a = 0; a < ids.size(); a += 1 + ids.size() / 100)
    for (const Index b : ids)
      largest = std::max(
          largest, std::abs((after.row(ids[a]) - after.row(b)).norm() - (before.row(ids[a]) - before.row(b)).norm()));
  return largest;
}

TEST(RotationLaws, RigidRegionsKeepTheirDistances)
{
  const Mesh sphere = test::icosphere(5);  // 10,242 vertices
  const std::vector<Index> top = between(sphere, 0.98, 1);
  const std::vector<Index> bottom = between(sphere, 0, 0.02);
  const std::vector<Index> ring = between(sphere, 0.4, 0.6);
  for (const std::vector<Index>& region :
       {std::vector<Index>(ring.begin(), ring.begin() + 10), between(sphere, 0.03, 0.97)}) {
    ASSERT_GT(region.size(), 9U);
    const ConstraintList list =
        test::listOf({test::hold(bottom), turn("top", top, 150, Vector3(2, 0, 0.5)), test::rigid(region)});
    const DeformResult result = test::deformed(sphere, list, {});
    ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LT(largestChangeOfDistance(sphere.positions, result.positions, region) / 2, kExact) << region.size();
    for (const Index v : region) EXPECT_EQ(result.rotations.row(v), result.rotations.row(region.front()));
    EXPECT_GT(angleDegrees(result.rotations.row(region.front()).transpose()), 20) << "it did turn";
  }
}

TEST(RotationLaws, ARegionTurnsAsItsFirstGivenRotationAndNotAsItsLowestId)
{
  const Mesh mesh = test::plate(6, 5);
  const ConstraintList list{
      "", {turn("handle", {20}, 90, Vector3(0.1, 0.2, 0.3)), test::rigid({10, 13, 20, 21}), test::hold({0, 1, 2, 10})}};
  const DeformResult result = test::deformed(mesh, list, {});
  ASSERT_EQ(result.report.solve.status, SolveStatus::Conflicts) << "vertex 10 cannot stay";
  EXPECT_EQ(result.report.constraints[1].status, ConstraintStatus::Met);
  const Eigen::Matrix3d R = rotationMatrix(kAxis, 90);
  for (const Index v : {10, 13, 21}) {
    const Vector3 expected = R * (mesh.positions.row(v) - mesh.positions.row(20)).transpose();
    EXPECT_LT((result.positions.row(v) - result.positions.row(20) - expected.transpose()).norm(), kExact) << v;
  }
}

TEST(RotationLaws, KeptDistancesTurnWithTheSurface)
{
  const Mesh mesh = test::plate(12, 4);
  ConstraintList list{"",
                      {test::hold(between(mesh, 0, 0.1)), turn("end", between(mesh, 0.9, 1), 100, Vector3(0, 0, 2))}};
  const SurfaceLocation a = AtVertex{30};
  const SurfaceLocation b = AtVertex{35};
  const double rest = (mesh.positions.row(30) - mesh.positions.row(35)).norm();
  const Positions without = test::deformed(mesh, list, {}).positions;
  EXPECT_GT(std::abs((without.row(30) - without.row(35)).norm() - rest), 1e-3 * rest) << "not kept by itself";

  list.constraints.push_back({"kept", true, RelativeConstraint{a, b, {}}});
  const DeformResult result = test::deformed(mesh, list, {});
  EXPECT_NEAR((result.positions.row(30) - result.positions.row(35)).norm(), rest, kExact);
  const Vector3 mean = (result.rotations.row(30) + result.rotations.row(35)).transpose() / 2;
  const Vector3 expected = rotationMatrix(mean) * (mesh.positions.row(30) - mesh.positions.row(35)).transpose();
  EXPECT_LT((result.positions.row(30).transpose() - result.positions.row(35).transpose() - expected).norm(), kExact);

  list.constraints.back().what = RelativeConstraint{a, b, Vector3(1, 2, 3)};
  const DeformResult given = test::deformed(mesh, list, {});
  EXPECT_LT((given.positions.row(30) - given.positions.row(35) - Eigen::RowVector3d(1, 2, 3)).norm(), kExact);
}

/// min |A u - f| under B u = d by the dense system of Lagrange multipliers, with the engine's rows and rotations.
Columns3 denseSolution(const Mesh& mesh, const DeformResult& result, Weights weights)
{
  const double unit = boundingBoxDiagonal(mesh.positions);
  const std::vector<Triangle> triangles = triangulate(mesh).triangles;
  const Eigen::MatrixXd L = test::denseL(mesh, triangles, weights, unit);
  const Eigen::VectorXd w = test::denseRowWeights(mesh, triangles, weights, unit);
  const Index n = mesh.vertexCount();
  const Eigen::MatrixX3d delta = L * mesh.positions;
  Eigen::MatrixX3d rotated = delta;
  for (Index i = 0; i < n; ++i)
    rotated.row(i) =
        (Eigen::AngleAxisd(2 * result.rotations.row(i).norm(), result.rotations.row(i).normalized().transpose()) *
         Vector3(delta.row(i).transpose()))
            .transpose();
  const Index m = static_cast<Index>(result.details->system.rows.size());
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(m, n);
  Eigen::MatrixX3d d(m, 3);
  for (Index r = 0; r < m; ++r) {
    for (const Term& term : result.details->system.rows[r].terms) B(r, term.index) = term.coefficient;
    d.row(r) = result.details->system.rows[r].target;
  }
  const Eigen::MatrixXd A = w.asDiagonal() * L;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + m, n + m);
  K.topLeftCorner(n, n) = A.transpose() * A;
  K.topRightCorner(n, m) = B.transpose();
  K.bottomLeftCorner(m, n) = B;
  Eigen::MatrixX3d right(n + m, 3);
  right << A.transpose() * (w.asDiagonal() * rotated), d;
  return K.fullPivLu().solve(right).topRows(n);
}

/// Something of every kind at random vertices of a mesh whose first `split` are one part of two.
ConstraintList someOfEverything(const Mesh& mesh, Index split, test::Random& random)
{
  std::vector<Index> ids(static_cast<std::size_t>(split));
  for (Index v = 0; v < split; ++v) ids[v] = v;
  for (std::size_t k = ids.size() - 1; k > 0; --k) std::swap(ids[k], ids[random.integer(0, static_cast<Index>(k))]);
  const Index other = random.integer(split, mesh.vertexCount() - 1);
  std::vector<Constraint> constraints{
      test::hold({ids[0], ids[1], ids[2]}),
      turn("handle", {ids[3], ids[4], ids[5]}, random.uniform(-300, 300), test::randomVector(random, 1)),
      test::rigid({ids[6], ids[7], ids[8]}),
      {"kept", true, RelativeConstraint{AtVertex{ids[9]}, AtVertex{ids[10]}, {}}},
      {"tied", true, RelativeConstraint{AtVertex{ids[11]}, AtVertex{other}, {}}},
      test::rigid({ids[12], other}),
      test::moveBy(AtVertex{ids[13]}, test::randomVector(random, 0.5))};
  for (std::size_t k = 0; k < constraints.size(); ++k) constraints[k].name = std::to_string(k);
  return {"", std::move(constraints)};
}

TEST(RotationLaws, PositionsAreThoseOfTheDenseSystem)
{
  const Mesh plate = test::plate(6, 4);
  const Mesh mesh = test::merged(plate, test::moved(test::icosphere(1), Vector3(3, 3, 3)));
  for (std::uint32_t seed = 0; seed < 20; ++seed)
    for (const Weights weights : {Weights::Cotangent, Weights::Uniform}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << name(weights));
      test::Random random(seed);
      const DeformResult result =
          test::deformed(mesh, someOfEverything(mesh, plate.vertexCount(), random), {weights, {}});
      ASSERT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
      ASSERT_TRUE(result.details->diagnosis.dependent.empty());
      EXPECT_LT(test::distance(result.positions, denseSolution(mesh, result, weights)), 1e-9);
    }
}

TEST(RotationLaws, AForceIsHowFastTheEnergyGrowsWithItsTarget)
{
  const Mesh mesh = test::plate(6, 5);
  const Vector3 shift(0.3, -0.7, 1);
  for (const Weights weights : {Weights::Cotangent, Weights::Uniform}) {
    const DeformResult result =
        test::deformed(mesh, test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{20}, shift)}), {weights, {}});
    // Lengths in diagonals of the bounding box.
    const double unit = boundingBoxDiagonal(mesh.positions);
    const std::vector<Triangle> triangles = triangulate(mesh).triangles;
    const Eigen::MatrixX3d Au = test::denseRowWeights(mesh, triangles, weights, unit).asDiagonal() *
                                test::denseL(mesh, triangles, weights, unit) *
                                ((result.positions - mesh.positions) / unit);
    // |A u|^2 / 2 is a square of the length of the shift, and the force has its direction.
    const double expected = Au.squaredNorm() / (shift.norm() / unit);
    EXPECT_NEAR(*result.report.constraints[1].multiplier, expected, 1e-9 * expected) << name(weights);
  }
}

TEST(RotationLaws, ForcesBalanceTheElasticForcesAndVanishAtRest)
{
  const Mesh mesh = test::plate(6, 5);
  const ConstraintList rest = test::listOf({test::hold({0, 1, 2}), test::moveBy(AtVertex{20}, Vector3::Zero())});
  for (const ConstraintOutcome& outcome : test::deformed(mesh, rest, {}).report.constraints)
    EXPECT_EQ(outcome.multiplier, 0);

  ConstraintList pulled = rest;
  std::get<PointConstraint>(pulled.constraints[1].what).to = Move{Vector3(0, 0, 1)};
  const DeformResult one = test::deformed(mesh, pulled, {});
  std::get<PointConstraint>(pulled.constraints[1].what).to = Move{Vector3(0, 0, 2)};
  const DeformResult two = test::deformed(mesh, pulled, {});
  EXPECT_GT(*one.report.constraints[1].multiplier, 0);
  EXPECT_NEAR(*two.report.constraints[1].multiplier, 2 * *one.report.constraints[1].multiplier,
              1e-9 * *two.report.constraints[1].multiplier);
  const Columns3& forces = one.multipliers();
  EXPECT_LT(forces.colwise().sum().norm(), 1e-9 * *one.report.constraints[1].multiplier) << "action is reaction";
  EXPECT_GT(forces.row(20).norm(), 0);
  EXPECT_LT(forces.row(40).norm(), 1e-9 * forces.row(20).norm()) << "no constraint, no force";
}

}  // namespace
}  // namespace holdfast
