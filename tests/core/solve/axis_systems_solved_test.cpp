// Rows with directions, solved axis by axis, beside LAPACK on all three coordinates at once.

#include <gtest/gtest.h>

#include <holdfast/constraints/axis_systems.h>
#include <holdfast/operators/operators.h>
#include <holdfast/solve/axis_solvers.h>

#include "support/meshes.h"
#include "support/random.h"
#include "support/solve_cases.h"
#include "support/whole_problem.h"

namespace holdfast {
namespace {

/// A row of some unknowns near one another, as a face point makes one.
ConstraintRow randomRow(test::Random& random, const SolverMesh& mesh, const RowDirections& directions)
{
  const Triangle& triangle = mesh.triangles[random.integer(0, static_cast<long>(mesh.triangles.size()) - 1)];
  ConstraintRow row;
  std::vector<Term> terms;
  for (const Index u : triangle) terms.push_back({u, random.uniform(0.1, 1)});
  std::ranges::sort(terms, {}, &Term::index);
  row.terms = FewTerms(terms);
  for (int k = 0; k < 3; ++k) row.shift[k] = random.uniform(-0.3, 0.3);
  row.shift = directions.held(row.shift);
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

/// A random problem on a small mesh, and its solvers.
struct RandomProblem {
  RandomProblem(std::uint32_t seed, const SolverOptions& options)
      : random(seed),
        mesh(test::solverMeshOf(seed % 2 == 0 ? test::icosphere(1) : test::plate(5, 4))),
        A(std::make_shared<const EnergyMatrix>(weightedRows(makeOperators(mesh, Weights::Cotangent)))),
        system(randomSystem(random, mesh)),
        eliminated(std::make_shared<const EliminatedByAxes>(system, mesh, kRankTolerance)),
        solvers(makeAxisSolvers({A, eliminated, mesh.rest, {}}, options)),
        f(mesh.unknownCount(), 3)
  {
    for (double& value : f.reshaped()) value = random.uniform(-0.1, 0.1);
  }

  [[nodiscard]] Displacement solved() const
  {
    return solvers.value->solve(diagnose(*eliminated, system, mesh).targets, f);
  }

  test::Random random;
  SolverMesh mesh;
  std::shared_ptr<const EnergyMatrix> A;
  ConstraintSystem system;
  std::shared_ptr<const EliminatedByAxes> eliminated;
  AxisSolversResult solvers;
  Columns3 f;
};

class SolvedByAxes : public testing::TestWithParam<Backend> {
 protected:
  [[nodiscard]] static SolverOptions options() { return {SolverKind::Hard, GetParam(), 5}; }
};

TEST_P(SolvedByAxes, AgreesWithLapackOnAllCoordinatesAtOnce)
{
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const RandomProblem problem(seed, options());
    ASSERT_TRUE(problem.solvers) << problem.solvers.failure;
    const Columns3 u = problem.solved().u;
    for (const ConstraintRow& row : problem.system.rows) {
      Vector3 left = row.shift;
      for (const Term& term : row.terms) left -= term.coefficient * u.row(term.index).transpose();
      EXPECT_LE(row.directions.held(left).norm(), 1e-13);
    }
    const std::optional<Columns3> expected =
        test::wholeSolution(Eigen::MatrixXd(problem.A->matrix()), problem.f, problem.system);
    if (!expected) GTEST_SKIP() << "LAPACK was not found when the tests were configured (package liblapack-dev)";
    EXPECT_LT((u - *expected).norm(), 1e-10 * expected->norm());
  }
}

TEST_P(SolvedByAxes, GoesOnFromASolution)
{
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    RandomProblem problem(seed, options());
    Displacement near = problem.solved();
    for (ConstraintRow& row : problem.system.rows) row.shift *= 1.25;
    const Columns3 expected = problem.solved().u;
    const std::vector<RowTargets> targets = diagnose(*problem.eliminated, problem.system, problem.mesh).targets;
    const Displacement found = problem.solvers.value->solveFrom(std::move(near), targets, problem.f);
    EXPECT_LT((found.u - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST_P(SolvedByAxes, HasMultipliersThatBalanceTheEnergy)
{
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const RandomProblem problem(seed, options());
    const Columns3 u = problem.solved().u;
    const Columns3 gradient = problem.A->matrix().transpose() * (problem.f - problem.A->matrix() * u);
    const Columns3 ofRows = problem.eliminated->multipliers(gradient);
    Columns3 held = Columns3::Zero(u.rows(), 3);
    for (std::size_t r = 0; r < problem.system.rows.size(); ++r) {
      const ConstraintRow& row = problem.system.rows[r];
      const Vector3 force = ofRows.row(static_cast<Index>(r));
      EXPECT_LT((row.directions.held(force) - force).norm(), 1e-12 * gradient.norm()) << "a free direction pulls";
      for (const Term& term : row.terms) held.row(term.index) += term.coefficient * force.transpose();
    }
    EXPECT_LT((held - gradient).norm(), 1e-9 * gradient.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, SolvedByAxes, testing::ValuesIn(test::backends()),
                         [](const auto& param) { return std::string(name(param.param)); });

TEST(EliminatedByAxes, HasRowsThatConflictAlongOneAxis)
{
  const SolverMesh mesh = test::solverMeshOf(test::plate(3, 3));
  ConstraintSystem system;
  for (const RowDirections& directions : {RowDirections(), RowDirections::along({0, 0, 1})}) {
    ConstraintRow& row = system.rows.emplace_back();
    row.terms = {{4, 1.0}};
    row.target = row.shift = Vector3::Zero();
    row.directions = directions;
  }
  system.rows[1].shift = {0, 0, 0.25};
  const EliminatedByAxes eliminated(system, mesh, kRankTolerance);
  ASSERT_EQ(eliminated.parts().size(), 2U);
  const Diagnosis diagnosis = diagnose(eliminated, system, mesh);
  EXPECT_EQ(diagnosis.status, (std::vector{RowStatus::Independent, RowStatus::Conflicting}));
  ASSERT_EQ(diagnosis.dependent.size(), 1U);
  EXPECT_EQ(diagnosis.dependent.front().gap, Vector3(0, 0, 0.25));
  EXPECT_EQ(diagnosis.dependent.front().dependency.row, 1);
  EXPECT_EQ(diagnosis.dependent.front().dependency.terms, (std::vector<Term>{{0, 1.0}}));
  EXPECT_EQ(diagnosis.targets.size(), 2U);
}

TEST(EliminatedByAxes, HasRowsThatRepeatOthersAlongSomeAxesAlone)
{
  const SolverMesh mesh = test::solverMeshOf(test::plate(3, 3));
  ConstraintSystem system;
  for (const RowDirections& directions : {RowDirections::along({0, 0, 1}), RowDirections()}) {
    ConstraintRow& row = system.rows.emplace_back();
    row.terms = {{4, 1.0}};
    row.target = row.shift = Vector3::Zero();
    row.directions = directions;
  }
  const Diagnosis diagnosis = diagnose(EliminatedByAxes(system, mesh, kRankTolerance), system, mesh);
  EXPECT_EQ(diagnosis.status, (std::vector{RowStatus::Independent, RowStatus::Independent}));
  EXPECT_EQ(diagnosis.dependent.size(), 1U) << "along z it follows";
}

}  // namespace
}  // namespace holdfast
