#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/find_dependencies.h>
#include <holdfast/elimination/large_component.h>

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

/// 500 points in faces of a sphere, two in five faces of one side of it; each fifth is a repetition of an earlier one,
/// others lie in a face that has points already. All agree with one displacement of the whole.
ConstraintList overlappingPoints(std::uint32_t seed)
{
  test::Random random(seed);
  const Vector3 shift(0.1, 0.2, -0.3);
  std::vector<Constraint> constraints;
  for (Index k = 0; k < 500; ++k) {
    if (k % 5 == 4) {
      constraints.push_back(constraints[random.integer(0, k - 1)]);
      continue;
    }
    const Index face =
        k % 7 == 6 ? std::get<AtFace>(std::get<PointConstraint>(constraints[k / 2].what).at).face : 5 * k / 2;
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
  for (const ConstraintRow& row : makeConstraintSystem(list, mesh, makeSolverMesh(mesh, triangulation),
                                                       SurfaceLocator(mesh, triangulation), "list")
                                      .rows)
    result.rows.push_back(row.terms);
  for (RowComponent& component : connectedRows(result.rows, mesh.vertexCount()))
    if (component.rows.size() > result.largest.rows.size()) result.largest = std::move(component);
  return result;
}

void expectAlike(const std::vector<Dependency>& sparse, const std::vector<Dependency>& sequential)
{
  ASSERT_EQ(sparse.size(), sequential.size());
  for (std::size_t k = 0; k < sparse.size(); ++k) {
    EXPECT_EQ(sparse[k].row, sequential[k].row);
    ASSERT_EQ(sparse[k].terms.size(), sequential[k].terms.size()) << "row " << sparse[k].row;
    double largest = 1;
    for (const Term& term : sequential[k].terms) largest = std::max(largest, std::abs(term.coefficient));
    for (std::size_t p = 0; p < sparse[k].terms.size(); ++p) {
      EXPECT_EQ(sparse[k].terms[p].index, sequential[k].terms[p].index);
      EXPECT_NEAR(sparse[k].terms[p].coefficient, sequential[k].terms[p].coefficient, 1e-8 * largest);
    }
  }
}

TEST(LargeComponents, AreJudgedAlikeBySparseAndSequentialElimination)
{
  const Mesh mesh = test::icosphere(3);
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    const Rows rows = rowsOf(mesh, overlappingPoints(seed));
    ASSERT_GT(rows.largest.rows.size(), 300U);
    ASSERT_FALSE(isDense(rows.largest));
    const std::vector<Dependency> sparse = sparseDependencies(rows.rows, rows.largest);
    EXPECT_GT(sparse.size(), 60U) << "the planted ones";
    expectAlike(sparse, sequentialDependencies(rows.rows, rows.largest));
  }
}

TEST(LargeComponents, AreJudgedAlikeWhereCircuitsLeadFromFaceToFace)
{
  // A point well inside every face: more points than vertices, told by circuits through many faces, with coefficients
  // that grow from face to face, up to 1e6.
  const Mesh mesh = test::plate(6, 6);
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    std::vector<Constraint> constraints;
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      const double a = random.uniform(0.1, 0.8);
      const double b = random.uniform(0.1, 0.9 - a);
      constraints.push_back(test::moveBy(AtFace{f, {a, b, 1 - a - b}}, Vector3::UnitZ()));
    }
    const Rows rows = rowsOf(mesh, test::listOf(constraints));
    expectAlike(sparseDependencies(rows.rows, rows.largest), sequentialDependencies(rows.rows, rows.largest));
  }
}

TEST(LargeComponents, AreMetToThePromise)
{
  const Mesh mesh = test::icosphere(3);
  test::Random random(17);
  ConstraintList list = overlappingPoints(17);
  for (const Index face : {3, 700, 1100})
    list.constraints.push_back({"far " + std::to_string(face), true,
                                PointConstraint{randomFacePoint(random, face), Move{test::randomVector(random, 0.3)}}});
  for (const Backend backend : test::backends()) {
    const DeformResult result = test::deformed(mesh, list, {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
    EXPECT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
  }
}

TEST(LargeComponents, GiveTheSameShapeWithMultipliersAsByABasis)
{
  // Other backends eliminate every row; our own keeps those of large components.
  const Mesh mesh = test::icosphere(3);
  test::Random random(3);
  std::vector<Constraint> constraints{test::hold({5}), test::hold({17})};
  for (Index face = 0; face < mesh.faces.size(); face += 3)
    constraints.push_back(test::moveBy(randomFacePoint(random, face), test::randomVector(random, 0.05)));
  const ConstraintList list = test::listOf(std::move(constraints));
  const auto deformedBy = [&](Backend backend) {
    return test::deformed(mesh, list, {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
  };
  const DeformResult own = deformedBy(Backend::Holdfast);
  EXPECT_THAT(own.report.solve.method, testing::HasSubstr("multipliers"));
  EXPECT_LE(own.report.solve.maxResidualRelative, 1e-14);
  for (const Backend backend : test::backends()) {
    const DeformResult other = deformedBy(backend);
    EXPECT_NE(other.report.solve.status, SolveStatus::Failed) << other.report.solve.message;
    EXPECT_LT(test::distance(own.positions, other.positions), 1e-11) << name(backend);
    for (std::size_t c = 0; c < list.constraints.size(); ++c)
      EXPECT_EQ(own.report.constraints[c].status, other.report.constraints[c].status) << c;
  }
}

/// A point of every face for each of `weights`, where `target` has it.
template <class Weights>
ConstraintList pointsOfEveryFace(const Mesh& target, const Weights& weights)
{
  std::vector<Constraint> constraints;
  for (Index f = 0; f < target.faces.size(); ++f)
    for (const std::array<double, 3>& w : weights()) {
      Vector3 place = Vector3::Zero();
      for (std::size_t k = 0; k < 3; ++k) place += w[k] * target.positions.row(target.faces[f][k]).transpose();
      constraints.push_back(test::moveTo(AtFace{f, {w[0], w[1], w[2]}}, place));
    }
  return test::listOf(std::move(constraints));
}

std::vector<std::array<double, 3>> nearEachCorner()
{
  return {{0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}, {0.2, 0.2, 0.6}};
}

struct AnywhereInside {
  test::Random& random;
  std::vector<std::array<double, 3>> operator()() const
  {
    const double a = random.uniform(0.05, 0.9);
    const double b = random.uniform(0.02, 0.95 - a);
    return {{a, b, 1 - a - b}};
  }
};

Mesh rotated(const Mesh& mesh)
{
  return test::transformed(mesh, Eigen::Affine3d(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized())));
}

std::size_t countOf(const DeformResult& result, ConstraintStatus status)
{
  return std::count_if(result.report.constraints.begin(), result.report.constraints.end(),
                       [&](const ConstraintOutcome& outcome) { return outcome.status == status; });
}

TEST(LargeComponents, PointsThatTellEveryVertexSeveralTimesOverAreMet)
{
  // Rounding of the targets grows along the circuits of the earliest basis; nothing may come of it.
  const Mesh mesh = test::plate(9, 8);
  const Mesh target = rotated(mesh);
  for (const Backend backend : test::backends()) {
    const DeformResult result = test::deformed(mesh, pointsOfEveryFace(target, nearEachCorner),
                                               {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_EQ(countOf(result, ConstraintStatus::Redundant), result.report.constraints.size() - mesh.vertexCount());
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-14);
    EXPECT_LT(test::distance(result.positions, target.positions), 1e-12);
    EXPECT_EQ(result.report.solve.unknowns, 0);
  }
}

TEST(LargeComponents, AgreeingPointsAreMetHoweverFarTheirCircuitsLead)
{
  // By the earliest basis, coefficients would grow to 1e16 here: no order of the digits of a double holds that.
  const Mesh mesh = test::plate(20, 20);
  const Mesh target = rotated(mesh);
  for (const Backend backend : test::backends())
    for (std::uint32_t seed = 1; seed < 4; ++seed) {
      SCOPED_TRACE(seed);
      test::Random random(seed);
      const DeformResult result = test::deformed(mesh, pointsOfEveryFace(target, AnywhereInside{random}),
                                                 {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
      EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
      EXPECT_EQ(countOf(result, ConstraintStatus::Conflicting), 0U);
      EXPECT_LE(result.report.solve.maxResidualRelative, 1e-15);
    }
}

TEST(LargeComponents, PointsThatDisagreeAreLeftOutAndTheOthersMet)
{
  const Mesh mesh = test::plate(12, 12);
  test::Random random(5);
  ConstraintList list = pointsOfEveryFace(rotated(mesh), AnywhereInside{random});
  for (Constraint& constraint : list.constraints)
    std::get<Target>(std::get<PointConstraint>(constraint.what).to).place += test::randomVector(random, 1e-3);
  for (const Backend backend : test::backends()) {
    const DeformResult result = test::deformed(mesh, list, {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts) << result.report.solve.message;
    EXPECT_EQ(countOf(result, ConstraintStatus::Met), static_cast<std::size_t>(mesh.vertexCount()));
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
  }
}

}  // namespace
}  // namespace holdfast
