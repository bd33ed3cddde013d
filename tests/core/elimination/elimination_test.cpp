#include <algorithm>

#include <gtest/gtest.h>

#include <holdfast/elimination/diagnosis.h>
#include <holdfast/elimination/find_dependencies.h>

#include "support/dense_operators.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

/// Random points of a mesh, eliminated.
struct EliminatedPoints {
  Mesh mesh;
  ConstraintList list;
  Triangulation triangulation = triangulate(mesh);
  SolverMesh solverMesh = makeSolverMesh(mesh, triangulation);
  ConstraintSystem system = makeConstraintSystem(list, mesh, solverMesh, SurfaceLocator(mesh, triangulation), "list");
  EliminatedConstraints eliminated = eliminate(system, solverMesh);
  Eigen::MatrixXd B = test::denseRows(list, mesh).B;

  [[nodiscard]] SparseMatrix Q2() const { return eliminated.elimination.wholeQ2(); }
};

/// Calls `check(problem)` for few and many, isolated and overlapping points on every mesh; the most make components
/// beyond the dense blocks.
template <class Check>
void forEachSetOfPoints(Check&& check)
{
  for (const test::NamedMesh& named : test::lawMeshes())
    for (const int count : {1, 5, 20, 60}) {
      SCOPED_TRACE(named.name + ", " + std::to_string(count) + " points");
      test::Random random(static_cast<std::uint32_t>(count));
      check(EliminatedPoints{named.mesh, test::randomMoves(random, named.mesh, count, 0.3)});
    }
  test::Random random(5);
  const Mesh sphere = test::icosphere(2);
  check(EliminatedPoints{sphere, test::randomMoves(random, sphere, 130, 0.3)});
  std::vector<Constraint> points;
  for (Index face = 0; face < sphere.faces.size(); face += 3)
    points.push_back(test::moveBy(AtFace{face, {0.25, 0.125, 0.625}}, test::randomVector(random, 0.3)));
  check(EliminatedPoints{sphere, test::listOf(std::move(points))});
}

TEST(Elimination, Q2HasOrthonormalColumns)
{
  forEachSetOfPoints([](const EliminatedPoints& problem) {
    const Eigen::MatrixXd Q2 = problem.Q2();
    EXPECT_LT((Q2.transpose() * Q2 - Eigen::MatrixXd::Identity(Q2.cols(), Q2.cols())).cwiseAbs().maxCoeff(), 1e-14);
  });
}

TEST(Elimination, Q2IsWhatTheRowsMapToZero)
{
  forEachSetOfPoints([](const EliminatedPoints& problem) {
    EXPECT_LT((problem.B * problem.Q2()).cwiseAbs().maxCoeff(), 1e-14);
    const auto held = std::count(problem.eliminated.isHeld.begin(), problem.eliminated.isHeld.end(), true);
    const auto independent = static_cast<Index>(problem.system.rows.size() - problem.eliminated.dependencies.size());
    EXPECT_EQ(problem.Q2().cols(), problem.solverMesh.unknownCount() - held - independent);
  });
}

TEST(Elimination, FreeUnknownsHaveIdentityColumnsAndPinnedOnesNone)
{
  forEachSetOfPoints([](const EliminatedPoints& problem) {
    const Eigen::MatrixXd Q2 = problem.Q2();
    std::vector<bool> isPinned(static_cast<std::size_t>(Q2.rows()), false);
    std::vector<bool> isNamed = isPinned;
    for (const RowTerms& row : problem.eliminated.rows)
      for (const Term& term : row) isNamed[term.index] = true;
    for (const Index row : independentRows(problem.eliminated.dependencies, problem.eliminated.rows.size()))
      if (problem.system.rows[row].isPin()) isPinned[problem.system.rows[row].terms[0].index] = true;
    for (Index u = 0; u < Q2.rows(); ++u) {
      if (isPinned[u] || problem.eliminated.isHeld[u]) {
        EXPECT_EQ(Q2.row(u).squaredNorm(), 0) << u;
      } else if (!isNamed[u]) {
        EXPECT_EQ((Q2.row(u).array() == 1).count(), 1) << u;
        EXPECT_EQ((Q2.row(u).array() != 0).count(), 1) << u;
      }
    }
  });
}

TEST(Elimination, KeptRowsAreAllThatQ2LeavesToAsk)
{
  bool isAnyKept = false;
  forEachSetOfPoints([&](const EliminatedPoints& problem) {
    const Elimination& elimination = problem.eliminated.elimination;
    const std::vector<Index> kept = elimination.kept();
    const Eigen::MatrixXd asked = problem.B * elimination.Q2();
    for (Index row = 0; row < asked.rows(); ++row)
      EXPECT_EQ(std::ranges::binary_search(kept, row), asked.row(row).cwiseAbs().maxCoeff() > 1e-13) << row;
    EXPECT_EQ(elimination.Q2().cols(), elimination.wholeQ2().cols() + static_cast<Index>(kept.size()));
    isAnyKept = isAnyKept || !kept.empty();
  });
  EXPECT_TRUE(isAnyKept);
}

TEST(Elimination, TheParticularDisplacementMeetsIndependentRowsAndCopiesPins)
{
  forEachSetOfPoints([](const EliminatedPoints& problem) {
    const Columns3 d = shiftsOf(problem.system);
    const Columns3 u = problem.eliminated.elimination.particular(d);
    const Columns3 missed = problem.B * u - d;
    for (const Index row : independentRows(problem.eliminated.dependencies, problem.system.rows.size())) {
      EXPECT_LT(missed.row(row).norm(), 1e-13) << row;
      if (problem.system.rows[row].isPin()) {
        EXPECT_EQ(u.row(problem.system.rows[row].terms[0].index), d.row(row)) << row;
      }
    }
  });
}

TEST(Elimination, IsolatedPointsMakeBlocksOfTheirOwn)
{
  // An edge and a face far apart: one and two columns that are not of the identity.
  const Mesh mesh = test::grid(6, 5);
  const EliminatedPoints problem{mesh, test::listOf({test::moveBy(AtEdge{0, 1, 0.25}, {0, 0, 1}),
                                                     test::moveBy(AtFace{59, {0.25, 0.25, 0.5}}, {0, 0, 1})})};
  Index others = 0;
  for (Index k = 0; k < problem.Q2().cols(); ++k)
    if (Eigen::SparseVector<double>(problem.Q2().col(k)).nonZeros() > 1) ++others;
  EXPECT_EQ(others, 3);
  EXPECT_EQ(problem.Q2().cols(), 40);
}

TEST(Elimination, HoldsPartsWithoutARowAndLooseVertices)
{
  Mesh mesh = test::merged(test::tetrahedron(), test::tetrahedron());
  mesh.positions.conservativeResize(10, 3);
  mesh.positions.bottomRows(2).setConstant(7);
  const EliminatedPoints problem{
      mesh, test::listOf({test::moveBy(AtVertex{1}, {0, 0, 1}), test::moveBy(AtVertex{9}, {0, 0, 2})})};
  EXPECT_EQ(problem.eliminated.isHeld,
            (std::vector<bool>{false, false, false, false, true, true, true, true, true, false}));
  EXPECT_EQ(problem.Q2().cols(), 3);
}

}  // namespace
}  // namespace holdfast
