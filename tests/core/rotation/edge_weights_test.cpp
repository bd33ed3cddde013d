#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "core/rotation/rotation_cases.h"

namespace holdfast {
namespace {

using test::solverMeshOf;

using WeightOfEdge = std::map<std::pair<Index, Index>, double>;

WeightOfEdge weightsOf(const SolverMesh& mesh, Weights weights)
{
  WeightOfEdge result;
  for (const auto& [i, j, weight] : rotationEdgeWeights(makeOperators(mesh, weights)).edges) {
    EXPECT_LT(i, j);
    EXPECT_TRUE(result.try_emplace({i, j}, weight).second) << "each edge once";
  }
  return result;
}

/// The sums of cot of the angles across each edge, from side lengths alone: (b^2 + c^2 - a^2) / (4 area).
WeightOfEdge cotangentSums(const SolverMesh& mesh)
{
  WeightOfEdge result;
  for (const Triangle& t : mesh.triangles) {
    double squares[3];
    for (int k = 0; k < 3; ++k)
      squares[k] = (mesh.rest.row(t[(k + 1) % 3]) - mesh.rest.row(t[(k + 2) % 3])).squaredNorm();
    const double sum = squares[0] + squares[1] + squares[2];
    const double area4 =
        std::sqrt(sum * sum - 2 * (squares[0] * squares[0] + squares[1] * squares[1] + squares[2] * squares[2]));
    for (int k = 0; k < 3; ++k) result[std::minmax(t[(k + 1) % 3], t[(k + 2) % 3])] += (sum - 2 * squares[k]) / area4;
  }
  return result;
}

TEST(RotationEdgeWeights, UniformOnesAreOne)
{
  for (const test::NamedMesh& named : test::allMeshes()) {
    const SolverMesh mesh = solverMeshOf(named.mesh);
    std::map<std::pair<Index, Index>, double> expected;
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) expected[std::minmax(t[k], t[(k + 1) % 3])] = 1;
    EXPECT_EQ(weightsOf(mesh, Weights::Uniform), expected) << named.name;
  }
}

TEST(RotationEdgeWeights, OfThePaperAreTheCotangentsAcrossTheEdge)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    const SolverMesh mesh = solverMeshOf(named.mesh);
    const WeightOfEdge expected = cotangentSums(mesh);
    const WeightOfEdge found = weightsOf(mesh, Weights::CotangentPaper);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [edge, weight] : expected) EXPECT_NEAR(found.at(edge), weight, 1e-12) << named.name;
  }
}

TEST(RotationEdgeWeights, OfThePaperAreNegativeAcrossObtuseAnglesAndGuardedOnesAreNot)
{
  const SolverMesh mesh = solverMeshOf(test::triangle({0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}));
  EXPECT_NEAR(weightsOf(mesh, Weights::CotangentPaper).at({0, 1}), -0.75, 1e-15);
  EXPECT_EQ(weightsOf(mesh, Weights::Cotangent).at({0, 1}), 1e-6);
}

/// The figures of docs/math.md.
TEST(RotationEdgeWeights, OfGuardedCotangentsLieBetweenAMillionthAndTwiceTwentyOnEveryEdge)
{
  for (const test::NamedMesh& named : test::allMeshes()) {
    const SolverMesh mesh = solverMeshOf(named.mesh);
    const WeightOfEdge found = weightsOf(mesh, Weights::Cotangent);
    EXPECT_EQ(found.size(), weightsOf(mesh, Weights::Uniform).size()) << named.name;
    for (const auto& [edge, weight] : found) {
      EXPECT_GE(weight, 1e-6) << named.name;
      EXPECT_LE(weight, 2 * 20) << named.name;
    }
  }
}

TEST(RotationEdgeWeights, OfGoodTrianglesAreNotGuarded)
{
  const SolverMesh mesh = solverMeshOf(test::icosphere(2));
  EXPECT_EQ(weightsOf(mesh, Weights::Cotangent), weightsOf(mesh, Weights::CotangentPaper));
  const RotationWeights weights = rotationEdgeWeights(makeOperators(mesh, Weights::Cotangent));
  EXPECT_TRUE(weights.capped.empty());
  EXPECT_TRUE(weights.floored.empty());
}

TEST(RotationEdgeWeights, TellWhereTheyWereGuarded)
{
  // The first triangle is obtuse across its edge from 0 to 1, the second has an angle of a tenth of a degree.
  Mesh mesh = test::merged(test::triangle({0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}),
                           test::triangle({9, 0, 0}, {10, 0, 0}, {10, 0.002, 0}));
  const RotationWeights weights = rotationEdgeWeights(makeOperators(solverMeshOf(mesh), Weights::Cotangent));
  EXPECT_EQ(weights.capped, (std::vector<Index>{3, 4, 5}));
  EXPECT_EQ(weights.floored, (std::vector<Index>{0, 1})) << "not the edge across the right angle";
}

TEST(RotationEdgeWeights, DoNotDependOnTheScaleOfTheModel)
{
  for (const Weights weights : test::allWeights())
    for (const double scale : {1e-200, 1e-3, 1e200}) {
      const WeightOfEdge small = weightsOf(solverMeshOf(test::plate(4, 3)), weights);
      const Mesh mesh = test::transformed(test::plate(4, 3), Eigen::Affine3d(Eigen::Scaling(scale)));
      for (const auto& [edge, weight] : weightsOf(solverMeshOf(mesh), weights))
        EXPECT_NEAR(weight, small.at(edge), 1e-13) << name(weights) << " " << scale;
    }
}

TEST(RotationEdgeWeights, CountEveryTriangleOnAnEdge)
{
  Mesh fan{Positions(5, 3), {}};
  fan.positions << 0, 0, 0, 0, 0, 1, 1, 0, 0.5, 0, 1, 0.5, -1, 0, 0.5;
  for (const Index tip : {2, 3, 4}) fan.faces.add({0, 1, tip});
  EXPECT_NEAR(weightsOf(solverMeshOf(fan), Weights::Cotangent).at({0, 1}), 3 * 0.75, 1e-15);
}

}  // namespace
}  // namespace holdfast
