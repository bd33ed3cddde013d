#include <gtest/gtest.h>

#include <holdfast/elimination/reconciliation.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

struct EliminatedList {
  SolverMesh mesh;
  ConstraintSystem system;
  EliminatedConstraints eliminated;
};

EliminatedList eliminatedList(const Mesh& mesh, const ConstraintList& list)
{
  const Triangulation triangulation = triangulate(mesh);
  SolverMesh solverMesh = makeSolverMesh(mesh, triangulation);
  ConstraintSystem system = makeConstraintSystem(list, mesh, solverMesh, SurfaceLocator(mesh, triangulation), "list");
  EliminatedConstraints eliminated = eliminate(system, solverMesh);
  return {std::move(solverMesh), std::move(system), std::move(eliminated)};
}

/// Four points of one face, `apart` of each other, and a fifth at its first corner; another vertex held.
ConstraintList nearlyRepeated(double apart)
{
  std::vector<Constraint> constraints{test::hold({7})};
  for (const double k : {0.0, 1.0, 2.0, 4.0})
    constraints.push_back(
        test::moveBy(AtFace{0, {0.4 + k * apart, 0.3 - k * k * apart, 0.3 + (k * k - k) * apart}}, Vector3::Zero()));
  return test::listOf(std::move(constraints));
}

double largestMiss(const EliminatedList& problem, const Columns3& u, const Columns3& d)
{
  double largest = 0;
  for (std::size_t r = 0; r < problem.eliminated.rows.size(); ++r) {
    Vector3 missed = d.row(r);
    for (const Term& term : problem.eliminated.rows[r]) missed -= term.coefficient * u.row(term.index).transpose();
    largest = std::max(largest, missed.norm());
  }
  return largest;
}

TEST(Reconciliation, MissesNoRowByMoreThanTheSmallestChangeThatMakesAllAgree)
{
  const EliminatedList problem = eliminatedList(test::grid(4, 4), nearlyRepeated(1e-5));
  ASSERT_EQ(problem.eliminated.dependencies.size(), 1U);
  const Dependency& dependency = problem.eliminated.dependencies.front();
  Columns3 d = Columns3::Zero(problem.eliminated.rows.size(), 3);
  const double gap = 1e-6;
  d(dependency.row, 0) = gap;

  double squares = 1;
  for (const Term& term : dependency.terms) squares += term.coefficient * term.coefficient;
  const Columns3 u = reconciledParticular(problem.eliminated, {dependency.row}, d);
  double squaresOfMisses = 0;
  for (std::size_t r = 0; r < problem.eliminated.rows.size(); ++r) {
    Vector3 missed = d.row(r);
    for (const Term& term : problem.eliminated.rows[r]) missed -= term.coefficient * u.row(term.index).transpose();
    squaresOfMisses += missed.squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(squaresOfMisses), gap / std::sqrt(squares), 1e-9 * gap);

  // The independent rows alone put all of it on the dependent one.
  EXPECT_NEAR(largestMiss(problem, problem.eliminated.elimination.particular(d), d), gap, 1e-6 * gap);
}

TEST(Reconciliation, LeavesPinsAndOtherRowsAsTheyAre)
{
  ConstraintList list = nearlyRepeated(1e-3);
  list.constraints.push_back(test::moveBy(AtFace{20, {0.2, 0.3, 0.5}}, Vector3(1, 2, 3)));
  list.constraints.push_back(test::moveBy(AtVertex{7}, Vector3::Zero()));
  const EliminatedList problem = eliminatedList(test::grid(4, 4), list);
  std::vector<Index> redundant;
  for (const Dependency& dependency : problem.eliminated.dependencies) redundant.push_back(dependency.row);
  ASSERT_EQ(redundant.size(), 2U);
  Columns3 d = shiftsOf(problem.system);
  d.row(0) << 0.1, 0.2, 0.3;
  d.row(d.rows() - 1) = d.row(0);

  const Columns3 plain = problem.eliminated.elimination.particular(d);
  const Columns3 u = reconciledParticular(problem.eliminated, redundant, d);
  EXPECT_EQ(u.row(7), d.row(0)) << "a pin";
  EXPECT_LT((u - plain).cwiseAbs().maxCoeff(), 1e-12) << "nothing disagrees";
  EXPECT_LT(largestMiss(problem, u, d), 1e-14);
}

TEST(Reconciliation, JoinsBlocksThatARedundantRowHangsOn)
{
  // Each edge to a held vertex leaves one unknown, a block of its own; the face point hangs on three of them.
  const Mesh mesh = test::grid(2, 2);
  const ConstraintList list = test::listOf({test::hold({3, 5, 8}), test::moveBy(AtEdge{0, 3, 0.5}, Vector3::UnitX()),
                                            test::moveBy(AtEdge{1, 5, 0.5}, Vector3::UnitX()),
                                            test::moveBy(AtEdge{4, 8, 0.5}, Vector3::UnitX()),
                                            test::moveBy(AtFace{0, {0.2, 0.3, 0.5}}, 2 * Vector3::UnitX())});
  const EliminatedList problem = eliminatedList(mesh, list);
  ASSERT_EQ(problem.eliminated.dependencies.size(), 1U);
  Columns3 d = shiftsOf(problem.system);
  d(d.rows() - 1, 0) += 1e-9;
  const Columns3 u = reconciledParticular(problem.eliminated, {problem.eliminated.dependencies.front().row}, d);
  EXPECT_LT(largestMiss(problem, u, d), 0.9e-9) << "shared between the four";
  EXPECT_GT(largestMiss(problem, u, d), 1e-10) << "it cannot vanish";
}

TEST(Reconciliation, IsOfAllRowsThatShareCircuitsWithAMissedOne)
{
  // Five points of one face, where three are independent. The fourth asks for 3 times as much as it may miss, which
  // small changes of the three close: they would carry the fifth away. A face far off has such points that agree.
  ConstraintList list = test::listOf({test::hold({4})});
  for (const Index face : {0, 20})
    for (const double k : {0.0, 1.0, 2.0, 4.0, 5.0})
      list.constraints.push_back(
          test::moveBy(AtFace{face, {0.4 + k * 1e-2, 0.3 - k * k * 1e-2, 0.3 + (k * k - k) * 1e-2}}, Vector3::Zero()));
  const Mesh mesh = test::grid(4, 4);
  const auto rowsAsking = [&](double share) {
    const double limit = kConsistentShare * kPromisedResidual * makeSolverMesh(mesh, triangulate(mesh)).diagonal;
    std::get<Move>(std::get<PointConstraint>(list.constraints[4].what).to).shift.x() = share * limit;
    const EliminatedList problem = eliminatedList(mesh, list);
    KnownGaps known;
    return diagnose(problem.eliminated, problem.system, problem.mesh, known).targets.front().reconciled;
  };
  EXPECT_EQ(rowsAsking(3), (std::vector<Index>{4, 5}));
  EXPECT_EQ(rowsAsking(0.9), std::vector<Index>()) << "met as it is";
}

}  // namespace
}  // namespace holdfast
