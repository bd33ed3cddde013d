#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

TEST(LagrangeSolver, AgreesWithTheHardOne)
{
  test::forEachSolveCase([](const Mesh& mesh, DeformOptions options) {
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      test::Random random(seed);
      const ConstraintList list = test::randomMoves(random, mesh, static_cast<int>(3 + 5 * seed), 0.3);
      options.solver.kind = SolverKind::Hard;
      const Deformation hard = test::deformed(mesh, list, options);
      options.solver.kind = SolverKind::Lagrange;
      const Deformation lagrange = test::deformed(mesh, list, options);
      ASSERT_NE(hard.report.solve.status, SolveStatus::Failed) << hard.report.solve.message;
      EXPECT_EQ(lagrange.report.solve.status, hard.report.solve.status) << lagrange.report.solve.message;
      EXPECT_LT(test::distance(lagrange.positions, hard.positions), 1e-9);
    }
  });
}

TEST(LagrangeSolver, HasAnUnknownForEachIndependentRow)
{
  const Mesh mesh = test::icosphere(1);
  const ConstraintList list =
      test::listOf({test::hold({0, 1}), test::moveBy(AtFace{20, {0.5, 0.25, 0.25}}, {0, 0, 1}), test::hold({1})});
  const Deformation result =
      test::deformed(mesh, list, {Weights::Cotangent, {SolverKind::Lagrange, test::backends().front(), 5}});
  EXPECT_EQ(result.report.solve.unknowns, mesh.vertexCount() + 3);
  EXPECT_GT(result.report.solve.factorNonzeros, 0);
}

}  // namespace
}  // namespace holdfast
