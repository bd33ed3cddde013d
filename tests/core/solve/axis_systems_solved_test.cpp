// Rows with directions, solved axis by axis, beside LAPACK on all three coordinates at once.

#include <gtest/gtest.h>

#include <holdfast/constraints/axis_systems.h>
#include <holdfast/operators/operators.h>
#include <holdfast/solve/constrained_solver.h>

#include "support/lapack.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

/// A row of some unknowns near one another, as a face point makes one.
ConstraintRow randomRow(test::Random& random, const SolverMesh& mesh, RowDirections directions)
{
  const Triangle& triangle = mesh.triangles[random.integer(0, static_cast<long>(mesh.triangles.size()) - 1)];
  ConstraintRow row;
  std::vector<Term> terms;
  for (const Index u : triangle) terms.push_back({u, random.uniform(0.1, 1)});
  std::ranges::sort(terms, {}, &Term::index);
  row.terms = FewTerms(terms);
  for (int k = 0; k < 3; ++k) row.shift[k] = random.uniform(-0.3, 0.3);
  row.directions = directions;
  return row;
}

/// Placed points, points in planes and points on lines, whose directions are parallel or square to one another.
ConstraintSystem randomSystem(test::Random& random, const SolverMesh& mesh)
{
  const Vector3 a(random.uniform(-1, 1), random.uniform(-1, 1), 1);
  const Vector3 b = a.cross(Vector3(random.uniform(-1, 1), 1, random.uniform(-1, 1)));
  const std::array sorts{RowDirections(), RowDirections::along(a), RowDirections::along(-3 * b),
                         RowDirections::across(a), RowDirections::across(a.cross(b))};
  ConstraintSystem system;
  for (int k = 0; k < 9; ++k) system.rows.push_back(randomRow(random, mesh, sorts[k % sorts.size()]));
  return system;
}

/// All coordinates of all unknowns, x of all first.
struct WholeProblem {
  Eigen::MatrixXd A;
  Eigen::MatrixXd B;
  Eigen::VectorXd d;
};

WholeProblem wholeProblem(const Eigen::MatrixXd& A, const ConstraintSystem& system)
{
  const Index n = A.cols();
  WholeProblem result{Eigen::MatrixXd::Zero(3 * A.rows(), 3 * n), Eigen::MatrixXd(0, 3 * n), Eigen::VectorXd(0)};
  for (Index k = 0; k < 3; ++k) result.A.block(k * A.rows(), k * n, A.rows(), n) = A;
  const auto add = [&](const ConstraintRow& row, const Vector3& direction) {
    result.B.conservativeResize(result.B.rows() + 1, Eigen::NoChange);
    result.B.bottomRows(1).setZero();
    for (Index k = 0; k < 3; ++k)
      for (const Term& term : row.terms)
        result.B(result.B.rows() - 1, k * n + term.index) = direction[k] * term.coefficient;
    result.d.conservativeResize(result.B.rows());
    result.d[result.d.size() - 1] = direction.dot(row.shift);
  };
  for (const ConstraintRow& row : system.rows) {
    if (row.directions.areAll()) {
      for (int k = 0; k < 3; ++k) add(row, Vector3::Unit(k));
    } else if (row.directions.areAlongAxis()) {
      add(row, row.directions.axis());
    } else {
      const Vector3 first = row.directions.axis().unitOrthogonal();
      add(row, first);
      add(row, row.directions.axis().cross(first));
    }
  }
  return result;
}

Columns3 solvedByAxes(const ConstraintSystem& system, const SolverMesh& mesh, const EnergyMatrix& A, const Columns3& f,
                      Backend backend)
{
  const std::optional<Eigen::Matrix3d> frame = commonFrame(system.rows);
  EXPECT_TRUE(frame);
  std::vector<Columns3> ofSystems;
  for (const AxisSystem& some : axisSystems(system, *frame)) {
    const auto eliminated = std::make_shared<const EliminatedConstraints>(eliminate(some.system, mesh));
    const SolverResult solver =
        makeSolver({std::make_shared<const EnergyMatrix>(A), eliminated, mesh.rest}, {SolverKind::Hard, backend, 5});
    EXPECT_TRUE(solver) << solver.failure;
    ofSystems.push_back(solver.value->solve({shiftsOf(some.system), {}}, alongAxes(f, some.axes, *frame)).u);
  }
  return joinedAxes(ofSystems, *frame);
}

class SolvedByAxes : public testing::TestWithParam<Backend> {};

TEST_P(SolvedByAxes, AgreesWithLapackOnAllCoordinatesAtOnce)
{
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    test::Random random(seed);
    const Mesh mesh = seed % 2 == 0 ? test::icosphere(1) : test::plate(5, 4);
    const SolverMesh solverMesh = makeSolverMesh(mesh, triangulate(mesh));
    const EnergyMatrix A = weightedRows(makeOperators(solverMesh, Weights::Cotangent));
    const ConstraintSystem system = randomSystem(random, solverMesh);
    Columns3 f(solverMesh.unknownCount(), 3);
    for (double& value : f.reshaped()) value = random.uniform(-0.1, 0.1);

    const Columns3 u = solvedByAxes(system, solverMesh, A, f, GetParam());
    for (const ConstraintRow& row : system.rows) {
      Vector3 left = row.shift;
      for (const Term& term : row.terms) left -= term.coefficient * u.row(term.index).transpose();
      EXPECT_LE(row.directions.held(left).norm(), 1e-13);
    }
    const WholeProblem whole = wholeProblem(Eigen::MatrixXd(A.matrix()), system);
    const auto expected =
        test::constrainedLeastSquaresByLapack(whole.A, whole.B, f.reshaped(), Eigen::MatrixXd(whole.d));
    if (!expected) GTEST_SKIP() << "LAPACK was not found when the tests were configured (package liblapack-dev)";
    EXPECT_LT((u.reshaped() - expected->col(0)).norm(), 1e-10 * expected->norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, SolvedByAxes, testing::ValuesIn(test::backends()),
                         [](const auto& param) { return std::string(name(param.param)); });

TEST(RowsWithDirections, ThatConflictAlongOneAxisHoldAlongTheOthers)
{
  const Mesh mesh = test::plate(3, 3);
  const SolverMesh solverMesh = makeSolverMesh(mesh, triangulate(mesh));
  ConstraintSystem system;
  for (const RowDirections& directions : {RowDirections(), RowDirections::along({0, 0, 1})}) {
    ConstraintRow& row = system.rows.emplace_back();
    row.terms = {{4, 1.0}};
    row.directions = directions;
  }
  system.rows[1].shift = {7, 8, 0.25};
  const std::vector<AxisSystem> systems = axisSystems(system, Eigen::Matrix3d::Identity());
  ASSERT_EQ(systems.size(), 2U);
  const auto diagnosed = [&](const AxisSystem& some) {
    return diagnose(eliminate(some.system, solverMesh), some.system, solverMesh);
  };
  EXPECT_EQ(diagnosed(systems[0]).status, std::vector{RowStatus::Independent});
  const Diagnosis z = diagnosed(systems[1]);
  EXPECT_EQ(z.status, (std::vector{RowStatus::Independent, RowStatus::Conflicting}));
  EXPECT_EQ(z.dependent.front().gap, Vector3(0, 0, 0.25));
}

}  // namespace
}  // namespace holdfast
