#include <algorithm>

#include <gtest/gtest.h>

#include <holdfast/elimination/find_dependencies.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

SurfaceLocation randomFacePoint(test::Random& random, Index face)
{
  const double a = random.uniform(0.05, 0.9);
  const double b = random.uniform(0.02, 0.95 - a);
  return AtFace{face, {a, b, 1 - a - b}};
}

/// 500 points in faces of a sphere, each fifth a repetition of an earlier one, each seventh the fourth point of a face,
/// all in agreement with one displacement of the whole.
ConstraintList overlappingPoints(const Mesh& mesh, std::uint32_t seed)
{
  test::Random random(seed);
  const Vector3 shift(0.1, 0.2, -0.3);
  std::vector<Constraint> constraints;
  for (Index k = 0; k < 500; ++k) {
    if (k % 5 == 4) {
      constraints.push_back(constraints[random.integer(0, k - 1)]);
      continue;
    }
    const Index face = k % 7 == 6 ? std::get<AtFace>(std::get<Point>(constraints[k / 2].what).at).face
                                  : random.integer(0, mesh.faces.size() - 1);
    constraints.push_back(test::moveBy(randomFacePoint(random, face), shift));
  }
  return test::listOf(std::move(constraints));
}

struct Rows {
  std::vector<RowTerms> rows;
  RowComponent largest;
};

Rows rowsOf(const Mesh& mesh, const ConstraintList& list)
{
  const Triangulation triangulation = triangulate(mesh);
  Rows result;
  for (const ConstraintRow& row :
       makeConstraintSystem(list, mesh, triangulation, makeSolverMesh(mesh, triangulation), "list").rows)
    result.rows.push_back(row.terms);
  for (RowComponent& component : connectedRows(result.rows, mesh.vertexCount()))
    if (component.rows.size() > result.largest.rows.size()) result.largest = std::move(component);
  return result;
}

TEST(LargeComponents, AreJudgedAlikeBySparseAndSequentialElimination)
{
  const Mesh mesh = test::icosphere(3);
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const Rows rows = rowsOf(mesh, overlappingPoints(mesh, seed));
    ASSERT_GT(rows.largest.rows.size(), 300U);
    ASSERT_FALSE(isDense(rows.largest));
    const std::vector<Dependency> sparse = sparseDependencies(rows.rows, rows.largest);
    const std::vector<Dependency> sequential = sequentialDependencies(rows.rows, rows.largest);
    ASSERT_GT(sparse.size(), 60U) << "the planted ones";
    ASSERT_EQ(sparse.size(), sequential.size());
    for (std::size_t k = 0; k < sparse.size(); ++k) {
      EXPECT_EQ(sparse[k].row, sequential[k].row);
      ASSERT_EQ(sparse[k].partners.size(), sequential[k].partners.size()) << "row " << sparse[k].row;
      for (std::size_t p = 0; p < sparse[k].partners.size(); ++p) {
        EXPECT_EQ(sparse[k].partners[p].row, sequential[k].partners[p].row);
        EXPECT_NEAR(sparse[k].partners[p].coefficient, sequential[k].partners[p].coefficient, 1e-8);
      }
    }
  }
}

TEST(LargeComponents, AreMetToThePromise)
{
  const Mesh mesh = test::icosphere(3);
  test::Random random(17);
  ConstraintList list = overlappingPoints(mesh, 17);
  for (const Index face : {3, 700, 1100})
    list.constraints.push_back({"far " + std::to_string(face), true,
                                Point{randomFacePoint(random, face), Move{test::randomVector(random, 0.3)}}});
  for (const Backend backend : test::backends()) {
    const Deformation result = test::deformed(mesh, list, {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
    EXPECT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
  }
}

TEST(LargeComponents, AllPointsOfAPlateMoveAsTheyAreTold)
{
  // A point in every face holds the plate nearly everywhere; a common turn is met by all.
  const Mesh mesh = test::plate(9, 8);
  const Eigen::AngleAxisd turn(0.7, Vector3(1, 2, 3).normalized());
  test::Random random(4);
  std::vector<Constraint> constraints;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const SurfaceLocation at = randomFacePoint(random, f);
    const auto& weights = std::get<AtFace>(at).weights;
    Vector3 rest = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) rest += weights[k] * mesh.positions.row(mesh.faces[f][k]).transpose();
    constraints.push_back(test::moveTo(at, turn * rest));
  }
  const Deformation result = test::deformed(mesh, test::listOf(constraints), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
}

}  // namespace
}  // namespace holdfast
