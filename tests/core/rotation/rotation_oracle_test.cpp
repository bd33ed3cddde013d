// The rotation field, (25) to (29), written out densely and solved by LU with complete pivoting.

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/rotation/rotation_cases.h"

namespace holdfast {
namespace {

using test::Random;

/// The angle at corner k, from the half-angle formula that needs no cross product.
double angle(const Positions& positions, const Triangle& t, int k)
{
  const Vector3 p = positions.row(t[k]);
  const Vector3 u = (Vector3(positions.row(t[(k + 1) % 3])) - p).normalized();
  const Vector3 v = (Vector3(positions.row(t[(k + 2) % 3])) - p).normalized();
  return 2 * std::atan2((u - v).norm(), (u + v).norm());
}

/// n x n, symmetric: the weights of all edges, where no guard acts.
Eigen::MatrixXd denseWeights(const SolverMesh& mesh, Weights weights)
{
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(mesh.unknownCount(), mesh.unknownCount());
  Eigen::MatrixXd isEdge = W;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Index i = t[(k + 1) % 3];
      const Index j = t[(k + 2) % 3];
      const double cotangent = 1 / std::tan(angle(mesh.rest, t, k));
      W(i, j) += cotangent;
      W(j, i) += cotangent;
      isEdge(i, j) = isEdge(j, i) = 1;
    }
  return weights == Weights::Uniform ? isEdge : W;
}

/// One value for all unknowns that `isTied` (n x n, symmetric) joins, however indirectly: the smallest of them.
std::vector<Index> smallestTied(const Eigen::MatrixXd& isTied)
{
  std::vector<Index> smallest;
  for (Index i = 0; i < isTied.rows(); ++i) smallest.push_back(i);
  for (bool hasChanged = true; hasChanged;) {
    hasChanged = false;
    for (Index i = 0; i < isTied.rows(); ++i)
      for (Index j = 0; j < isTied.cols(); ++j)
        if (isTied(i, j) != 0 && smallest[i] < smallest[j]) {
          smallest[j] = smallest[i];
          hasChanged = true;
        }
  }
  return smallest;
}

Eigen::MatrixXd tiesOf(const std::vector<std::vector<Index>>& rigidRegions, Index n)
{
  Eigen::MatrixXd ties = Eigen::MatrixXd::Zero(n, n);
  for (const std::vector<Index>& group : rigidRegions)
    for (const Index i : group)
      for (const Index j : group) ties(i, j) = 1;
  return ties;
}

struct DenseSolution {
  Eigen::MatrixXd q;
  double condition = 0;
};

/// A row for each unknown of the rotation field, (25) to (29): its value where q is given, the difference from the
/// first of its region, the sum of L q over a region at its first, and q = 0 where no edge or region leads to anything
/// given.
DenseSolution denseField(const Eigen::MatrixXd& W, const std::vector<Index>& given,
                         const std::vector<std::vector<Index>>& rigidRegions, const Columns3& values)
{
  const Index n = W.rows();
  const Eigen::MatrixXd ties = tiesOf(rigidRegions, n);
  const std::vector<Index> regionOf = smallestTied(ties);
  const std::vector<Index> partOf = smallestTied(ties + W.cwiseAbs());
  std::vector<Index> anchorOf(static_cast<std::size_t>(n), -1);
  std::vector<bool> isReached(static_cast<std::size_t>(n), false);
  for (std::size_t k = given.size(); k-- > 0;) {
    anchorOf[regionOf[given[k]]] = given[k];
    isReached[partOf[given[k]]] = true;
  }
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd f = Eigen::MatrixXd::Zero(n, 3);
  const Eigen::MatrixXd S = Eigen::MatrixXd(W.rowwise().sum().asDiagonal()) - W;
  for (Index i = 0; i < n; ++i) {
    const auto place = std::find(given.begin(), given.end(), i);
    const Index first = anchorOf[regionOf[i]] >= 0 ? anchorOf[regionOf[i]] : regionOf[i];
    if (place != given.end()) {
      M(i, i) = 1;
      f.row(i) = values.row(place - given.begin());
    } else if (!isReached[partOf[i]]) {
      M(i, i) = 1;
    } else if (first != i) {
      M(i, i) = 1;
      M(i, first) = -1;
    } else {
      for (Index j = 0; j < n; ++j)
        if (regionOf[j] == i) M.row(i) += S.row(j);
    }
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(M);
  return {lu.solve(f), 1 / lu.rcond()};
}

/// A plate or a sphere, shaken, with holes torn into it: boundaries, several parts, vertices without faces. For guarded
/// weights it is a sphere that is shaken so little that its triangles stay acute: no guard acts.
Mesh randomMesh(Random& random, Weights weights)
{
  const bool isGuarded = weights == Weights::Cotangent;
  const Mesh whole = !isGuarded && random.integer(0, 1) == 0 ? test::plate(6, 5) : test::icosphere(1);
  Mesh mesh{whole.positions, {}};
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions.row(v) += test::randomVector(random, isGuarded ? 0.05 : 0.2);
  for (Index f = 0; f < whole.faces.size(); ++f)
    if (random.uniform(0, 1) < 0.6) mesh.faces.add(whole.faces[f]);
  return mesh;
}

void expectDenseSolution(std::uint32_t seed, Weights weights, bool withRegions)
{
  Random random(seed);
  const SolverMesh mesh = test::solverMeshOf(randomMesh(random, weights));
  const std::vector<Index> given = test::someUnknowns(random, mesh, 5);
  std::vector<std::vector<Index>> rigidRegions;
  for (int k = 0; withRegions && k < 4; ++k) rigidRegions.push_back(test::someUnknowns(random, mesh, 3));
  Columns3 values(5, 3);
  for (Index k = 0; k < 5; ++k) values.row(k) = test::randomVector(random, 3);

  const DenseSolution expected = denseField(denseWeights(mesh, weights), given, rigidRegions, values);
  const double tolerance = 100 * std::numeric_limits<double>::epsilon() * expected.condition;
  ASSERT_LT(tolerance, 1e-6) << "this random mesh is no oracle";
  for (const Backend backend : test::backends()) {
    const RotationField found = test::solved(test::problemOf(mesh, weights, given, rigidRegions), backend, values);
    ASSERT_EQ(found.q.rows(), mesh.unknownCount());
    EXPECT_LE((found.q - expected.q).cwiseAbs().maxCoeff(), tolerance * expected.q.cwiseAbs().maxCoeff())
        << name(backend) << ", condition " << expected.condition;
  }
}

class RotationOracle : public testing::TestWithParam<Weights> {};

TEST_P(RotationOracle, IsMetWhereRotationsAreGivenAtVertices)
{
  for (std::uint32_t seed = 0; seed < 40; ++seed) expectDenseSolution(seed, GetParam(), false);
}

TEST_P(RotationOracle, IsMetWithRigidRegions)
{
  for (std::uint32_t seed = 100; seed < 140; ++seed) expectDenseSolution(seed, GetParam(), true);
}

INSTANTIATE_TEST_SUITE_P(Weights, RotationOracle, testing::ValuesIn(test::allWeights()),
                         [](const testing::TestParamInfo<Weights>& weights) {
                           std::string word(name(weights.param));
                           std::replace(word.begin(), word.end(), '-', '_');
                           return word;
                         });

}  // namespace
}  // namespace holdfast
