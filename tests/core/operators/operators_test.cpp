#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/mesh/edges.h>
#include <holdfast/operators/laplacian.h>
#include <holdfast/operators/operators.h>

#include "support/dense_operators.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/rounding.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using test::kEpsilon;
using test::solverMeshOf;
using testing::ElementsAre;
using testing::IsEmpty;

/// Calls `check(mesh, operators)` for every mesh and weighting.
template <class Check>
void forEachCase(Check&& check)
{
  for (const test::NamedMesh& named : test::lawMeshes())
    for (const Weights weights : test::allWeights()) {
      SCOPED_TRACE(named.name + ", " + std::string(name(weights)));
      check(named.mesh, makeOperators(solverMeshOf(named.mesh), weights));
    }
}

/// The sizes of the rows: sums of magnitudes.
Eigen::VectorXd rowSizes(const Eigen::MatrixXd& L)
{
  return L.cwiseAbs().rowwise().sum();
}

/// Unknowns that are on no boundary.
std::vector<Index> interior(const SolverMesh& mesh)
{
  std::set<Index> inside;
  for (const Triangle& triangle : mesh.triangles) inside.insert(triangle.begin(), triangle.end());
  forEachEdge(sortedHalfEdges(mesh.triangles), [&](std::span<const HalfEdge> edge) {
    if (edge.size() > 1) return;
    inside.erase(edge[0].a);
    inside.erase(edge[0].b);
  });
  return {inside.begin(), inside.end()};
}

TEST(Stiffness, IsSymmetricWithRowsOfSumZeroAndHasAnEntryForEachEdge)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const SolverMesh mesh = solverMeshOf(named.mesh);
    std::vector<CornerCotangents> cotangents;
    for (const Triangle& triangle : mesh.triangles) cotangents.push_back(cornerCotangents(mesh.rest, triangle));
    for (const auto& weights : {unitEdgeWeights(mesh.triangles), cotangentEdgeWeights(mesh.triangles, cotangents)}) {
      const SparseMatrix S = stiffness(mesh.unknownCount(), weights);
      const Eigen::MatrixXd dense = S;
      EXPECT_EQ(dense, dense.transpose());
      EXPECT_LT((dense.rowwise().sum().array() / rowSizes(dense).array()).abs().maxCoeff(), 8 * kEpsilon);
      EXPECT_EQ(S.nonZeros(), mesh.unknownCount() + 2 * static_cast<Index>(weights.size()));
      for (const EdgeWeight& weight : weights) EXPECT_LT(weight.i, weight.j);
    }
  }
}

TEST(Laplacian, HasRowsOfSumZero)
{
  forEachCase([](const Mesh&, const Operators& operators) {
    const Eigen::MatrixXd L = operators.L();
    EXPECT_LT((L.rowwise().sum().array() / rowSizes(L).array()).abs().maxCoeff(), 8 * kEpsilon);
  });
}

TEST(Laplacian, OfCotangentsVanishesOnLinearFunctionsInsideAFlatMesh)
{
  Mesh uneven = test::plate(7, 6);
  uneven.positions.col(2).setZero();
  for (const Mesh& mesh : {test::grid(6, 5), uneven})
    for (const Weights weights : {Weights::Cotangent, Weights::CotangentPaper}) {
      const SolverMesh solver = solverMeshOf(mesh);
      const Eigen::MatrixXd L = makeOperators(solver, weights).L();
      const Eigen::VectorXd values = 2 * mesh.positions.col(0) - 3 * mesh.positions.col(1);
      ASSERT_GT(interior(solver).size(), 10U);
      for (const Index i : interior(solver))
        EXPECT_LT(std::abs(L.row(i) * values), 16 * kEpsilon * rowSizes(L)[i] * values.cwiseAbs().maxCoeff());
    }
}

TEST(Laplacian, OfUnitWeightsVanishesOnLinearFunctionsInsideARegularGrid)
{
  const Mesh mesh = test::grid(6, 5);
  const SolverMesh solver = solverMeshOf(mesh);
  const SparseMatrix L = makeOperators(solver, Weights::Uniform).L();
  const Eigen::VectorXd result = L * (mesh.positions.col(0) - 7 * mesh.positions.col(1));
  for (const Index i : interior(solver)) EXPECT_NEAR(result[i], 0, 1e-13);
}

TEST(Laplacian, OfUnitWeightsIsTheDifferenceFromTheMeanOfTheNeighbours)
{
  const Mesh mesh = test::tetrahedron();
  const Eigen::MatrixXd L = makeOperators(solverMeshOf(mesh), Weights::Uniform).L();
  EXPECT_EQ(L.diagonal(), Eigen::Vector4d::Ones());
  EXPECT_DOUBLE_EQ(L(0, 1), -1.0 / 3);
}

TEST(Operators, AreThoseOfTheDefinition)
{
  forEachCase([](const Mesh& mesh, const Operators& operators) {
    const std::vector<Triangle> triangles = triangulate(mesh).triangles;
    const double unit = boundingBoxDiagonal(mesh.positions);
    const Eigen::MatrixXd L = test::denseL(mesh, triangles, operators.weights, unit);
    const Eigen::VectorXd difference = (Eigen::MatrixXd(operators.L()) - L).cwiseAbs().rowwise().maxCoeff();
    EXPECT_LT((difference.array() / rowSizes(L).array()).maxCoeff(), 1e-12);
    const Eigen::VectorXd rowWeights = test::denseRowWeights(mesh, triangles, operators.weights, unit);
    EXPECT_LT((operators.rowWeights - rowWeights).cwiseQuotient(rowWeights).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT((Eigen::MatrixXd(weightedRows(operators).matrix()) -
               operators.rowWeights.asDiagonal() * Eigen::MatrixXd(operators.L()))
                  .norm(),
              1e-14 * operators.L().norm());
  });
}

/// A vertex in the middle of six equilateral triangles of unit edges, in a plane.
Mesh hexagonFan()
{
  Mesh mesh;
  mesh.positions = Positions::Zero(7, 3);
  for (Index k = 0; k < 6; ++k) {
    const double angle = static_cast<double>(k) * std::numbers::pi / 3;
    mesh.positions.row(k + 1) << std::cos(angle), std::sin(angle), 0;
    mesh.faces.add({0, k + 1, (k + 1) % 6 + 1});
  }
  return mesh;
}

TEST(Operators, OfCotangentsAreEquation10WorkedOutByHand)
{
  // cot 60 degrees is 1 / sqrt 3, and the Voronoi area of the middle a third of six triangles of sqrt 3 / 4:
  // w = (2 / sqrt 3) / (2 sqrt 3 / 2) = 2/3. The bounding box is 2 by sqrt 3, so the square of its diagonal is 7.
  for (const Weights weights : {Weights::Cotangent, Weights::CotangentPaper}) {
    const Operators operators = makeOperators(solverMeshOf(hexagonFan()), weights);
    for (Index j = 1; j < 7; ++j) EXPECT_NEAR(operators.L().coeff(0, j), -2.0 / 3 * 7, 1e-13) << name(weights);
    EXPECT_NEAR(operators.L().coeff(0, 0), 6 * 2.0 / 3 * 7, 1e-13) << name(weights);
  }
}

TEST(Operators, OfCotangentsGiveTwiceTheMeanCurvature)
{
  // On the unit sphere: 2, along the normal. The diagonal of its box is 2 sqrt 3.
  const Mesh sphere = test::icosphere(4);
  for (const Weights weights : {Weights::Cotangent, Weights::CotangentPaper}) {
    const Operators operators = makeOperators(solverMeshOf(sphere), weights);
    const Columns3 delta = operators.delta / boundingBoxDiagonal(sphere.positions);
    EXPECT_LT((delta - 2 * sphere.positions).rowwise().norm().maxCoeff(), 0.01) << name(weights);
  }
}

TEST(Operators, DeltaIsLTimesTheRestShape)
{
  forEachCase([](const Mesh& mesh, const Operators& operators) {
    const Positions rest = mesh.positions / boundingBoxDiagonal(mesh.positions);
    const Columns3 expected = Eigen::MatrixXd(operators.L()) * rest;
    const Eigen::VectorXd allowed = 16 * kEpsilon * rest.cwiseAbs().maxCoeff() * rowSizes(operators.L());
    EXPECT_TRUE(((operators.delta - expected).cwiseAbs().rowwise().maxCoeff().array() <= allowed.array()).all());
  });
}

TEST(Operators, DoNotDependOnTheScale)
{
  forEachCase([](const Mesh& mesh, const Operators& operators) {
    for (const double scale : {1e-150, 1e-6, 1e6, 1e150}) {
      const Mesh scaled{mesh.positions * scale, mesh.faces};
      const Operators other = makeOperators(solverMeshOf(scaled), operators.weights);
      EXPECT_LT((operators.L() - other.L()).norm(), 1e-12 * operators.L().norm()) << scale;
      EXPECT_LT((operators.delta - other.delta).norm(), 1e-12 * operators.L().norm()) << scale;
    }
  });
}

TEST(Operators, DeltaKeepsItsDigitsFarFromTheOrigin)
{
  forEachCase([](const Mesh& mesh, const Operators& operators) {
    // A power of two, so that the shape survives the way out as well as it can.
    const double far = 1 << 20;
    const Mesh away = test::transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(far, far, far)));
    const Operators other = makeOperators(solverMeshOf(away), operators.weights);
    // Coordinates that large are rounded to 2 far epsilon; each row takes that up with its size.
    const double rounding = 2 * far * kEpsilon / boundingBoxDiagonal(mesh.positions);
    EXPECT_LT((operators.delta - other.delta).norm(), 64 * rounding * operators.L().norm());
  });
}

TEST(Operators, ReportNoGuardOnGoodMeshes)
{
  forEachCase([](const Mesh&, const Operators& operators) {
    EXPECT_THAT(operators.clampedCotangents, IsEmpty());
    EXPECT_THAT(operators.flooredAreas, IsEmpty());
    EXPECT_THAT(operators.undefinedRows, IsEmpty());
  });
}

/// A flat grid with its vertex 4 moved onto the line through its neighbours 3 and 0: the triangle (0, 4, 3) is a
/// segment.
Mesh gridWithAFlatTriangle()
{
  Mesh mesh = test::grid(2, 2);
  mesh.positions.row(4) << 0, 0.5, 0;
  return mesh;
}

TEST(Operators, GuardTrianglesWithoutAreaAndSaySo)
{
  const Operators operators = makeOperators(solverMeshOf(gridWithAFlatTriangle()), Weights::Cotangent);
  EXPECT_THAT(operators.clampedCotangents, ElementsAre(0, 3, 4));
  EXPECT_THAT(operators.undefinedRows, IsEmpty());
  EXPECT_TRUE(Eigen::MatrixXd(operators.L()).allFinite());
  EXPECT_TRUE(operators.delta.allFinite());
}

TEST(Operators, NameTheLiteralRowsThatAreUndefined)
{
  const Operators operators = makeOperators(solverMeshOf(gridWithAFlatTriangle()), Weights::CotangentPaper);
  EXPECT_THAT(operators.undefinedRows, ElementsAre(0, 3, 4));
}

/// The figure of docs/math.md.
TEST(Operators, RaiseTinyAreasToAThousandthOfTheMean)
{
  Mesh mesh = test::grid(4, 4);
  mesh.positions.conservativeResize(26, 3);
  mesh.positions.row(25) << 0.5, -1e-4, 0;
  mesh.faces.add({0, 25, 1});
  const Operators operators = makeOperators(solverMeshOf(mesh), Weights::Cotangent);
  EXPECT_THAT(operators.flooredAreas, ElementsAre(25));
  EXPECT_THAT(operators.clampedCotangents, ElementsAre(0, 1, 25));
  const Eigen::VectorXd areas = operators.rowWeights.cwiseAbs2();
  EXPECT_NEAR(areas[25], (areas.sum() - areas[25]) / 26 / 1000, 1e-3 * areas[25]);
}

TEST(Operators, LeaveRowsOfLooseVerticesEmpty)
{
  Mesh mesh = test::tetrahedron();
  mesh.positions.conservativeResize(5, 3);
  mesh.positions.row(4) << 9, 9, 9;
  for (const Weights weights : test::allWeights()) {
    const Operators operators = makeOperators(solverMeshOf(mesh), weights);
    EXPECT_EQ(Eigen::MatrixXd(operators.L()).row(4).norm(), 0);
    EXPECT_EQ(Eigen::MatrixXd(operators.L()).col(4).norm(), 0);
    EXPECT_THAT(operators.undefinedRows, IsEmpty());
    EXPECT_TRUE(operators.delta.allFinite());
  }
}

}  // namespace
}  // namespace holdfast
