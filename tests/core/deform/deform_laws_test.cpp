
#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/operators/operators.h>
#include <holdfast/solve/constrained_solver.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/rounding.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using test::deformed;
using test::distance;

/// Pins, points of edges and points of faces that all move, spread over a mesh so that every part has some.
ConstraintList someMoves(const Mesh& mesh)
{
  test::Random random(31);
  ConstraintList list = test::randomMoves(random, mesh, 9, 0.3);
  list.constraints.push_back({"first", true, PointConstraint{AtVertex{0}, Move{{0.1, 0, 0}}}});
  list.constraints.push_back({"last", true, PointConstraint{AtVertex{mesh.vertexCount() - 1}, Move{{0, 0.1, 0}}}});
  return list;
}

/// The list with every target taken through `motion`, for a mesh that was taken through it.
ConstraintList taken(const ConstraintList& list, const Eigen::Affine3d& motion)
{
  ConstraintList result = list;
  for (Constraint& constraint : result.constraints) {
    auto& move = std::get<Move>(std::get<PointConstraint>(constraint.what).to);
    move.shift = motion.linear() * move.shift;
  }
  return result;
}

void expectOk(const DeformResult& result)
{
  ASSERT_TRUE(result.report.solve.status == SolveStatus::Ok || result.report.solve.status == SolveStatus::Conflicts)
      << result.report.solve.message;
  EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
}

/// Deforms a mesh, and deforms it after `motion`; the one result is the other after `motion`.
void expectCommutes(const Mesh& mesh, const DeformOptions& options, const Eigen::Affine3d& motion, double tolerance)
{
  const ConstraintList list = someMoves(mesh);
  const DeformResult first = deformed(mesh, list, options);
  const DeformResult second = deformed(test::transformed(mesh, motion), taken(list, motion), options);
  expectOk(first);
  expectOk(second);
  const Mesh expected = test::transformed({first.positions, mesh.faces}, motion);
  EXPECT_LT(distance(second.positions, expected.positions), tolerance);
}

TEST(DeformLaws, ConstraintsThatAskForRestMoveNothing)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    ConstraintList list = someMoves(mesh);
    for (Constraint& constraint : list.constraints)
      std::get<Move>(std::get<PointConstraint>(constraint.what).to).shift.setZero();
    const DeformResult result = deformed(mesh, list, options);
    expectOk(result);
    EXPECT_EQ(result.positions, mesh.positions);
  });
}

TEST(DeformLaws, TargetsWrittenOutAtRestMoveNothing)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    ConstraintList list = someMoves(mesh);
    for (Constraint& constraint : list.constraints) {
      auto& point = std::get<PointConstraint>(constraint.what);
      Vector3 rest = Vector3::Zero();
      if (const auto* at = std::get_if<AtVertex>(&point.at)) rest = mesh.positions.row(at->vertex);
      if (const auto* at = std::get_if<AtEdge>(&point.at))
        rest = at->t * mesh.positions.row(at->i) + (1 - at->t) * mesh.positions.row(at->j);
      if (const auto* at = std::get_if<AtFace>(&point.at))
        for (std::size_t k = at->weights.size(); k-- > 0;)
          rest += at->weights[k] * mesh.positions.row(mesh.faces[at->face][k]).transpose();
      point.to = Target{rest};
    }
    const DeformResult result = deformed(mesh, list, options);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LE(distance(result.positions, mesh.positions), 1e-12);
  });
}

TEST(DeformLaws, EqualMovesOfAllConstraintsMoveTheMeshEqually)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    const Vector3 shift(0.1, -0.7, 0.3);
    ConstraintList list = someMoves(mesh);
    for (Constraint& constraint : list.constraints)
      std::get<Move>(std::get<PointConstraint>(constraint.what).to).shift = shift;
    const DeformResult result = deformed(mesh, list, options);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LT(distance(result.positions, test::moved(mesh, shift).positions), 1e-11);
  });
}

// The three laws below compare solutions of problems whose matrices differ by rounding. On these meshes the condition
// numbers of the reduced problems are about 1e3, residuals are about as large as the solution, so that solutions may
// differ by (1e3)^2 epsilon, 1e-10.
constexpr double kCommutes = 1e-10;

TEST(DeformLaws, TranslationsCommuteWithTheSolve)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    expectCommutes(mesh, options, Eigen::Affine3d(Eigen::Translation3d(3, -2, 5)), kCommutes);
  });
}

TEST(DeformLaws, RotationsCommuteWithTheSolve)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    const Eigen::Affine3d turn(Eigen::AngleAxisd(1.1, Vector3(1, -2, 0.5).normalized()));
    expectCommutes(mesh, options, turn, kCommutes);
  });
}

TEST(DeformLaws, UniformScalesCommuteWithTheSolve)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    for (const double scale : {1e-6, 1e-3, 7.0, 1e6})
      expectCommutes(mesh, options, Eigen::Affine3d(Eigen::Scaling(scale)), kCommutes);
  });
}

TEST(DeformLaws, ConstraintsAreMetFarFromTheOrigin)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    const double far = 1e6 * boundingBoxDiagonal(mesh.positions);
    const Mesh away = test::moved(mesh, {far, -far, far});
    const ConstraintList list = someMoves(away);
    const DeformResult result = deformed(away, list, options);
    ASSERT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
    for (const ConstraintOutcome& outcome : result.report.constraints) {
      ASSERT_TRUE(outcome.residual && outcome.limit);
      EXPECT_LE(*outcome.residual, *outcome.limit);
    }
    EXPECT_LE(result.report.solve.maxResidual, 64 * test::kEpsilon * far);
    // The shape as it was rounded there, deformed here.
    const DeformResult here = deformed(test::moved(away, {-far, far, -far}), list, options);
    EXPECT_LT(distance(test::moved({result.positions, mesh.faces}, {-far, far, -far}).positions, here.positions), 1e-8);
  });
}

TEST(DeformLaws, TheNumberingOfVerticesDoesNotMatter)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    std::vector<Index> newIdOf(static_cast<std::size_t>(mesh.vertexCount()));
    for (Index v = 0; v < mesh.vertexCount(); ++v) newIdOf[v] = mesh.vertexCount() - 1 - v;
    for (std::size_t v = 0; v + 5 < newIdOf.size(); v += 3) std::swap(newIdOf[v], newIdOf[v + 5]);
    const ConstraintList list = someMoves(mesh);
    ConstraintList renamed = list;
    for (Constraint& constraint : renamed.constraints) {
      SurfaceLocation& at = std::get<PointConstraint>(constraint.what).at;
      if (auto* vertex = std::get_if<AtVertex>(&at)) *vertex = {newIdOf[vertex->vertex]};
      if (auto* edge = std::get_if<AtEdge>(&at)) *edge = {newIdOf[edge->i], newIdOf[edge->j], edge->t};
    }
    const DeformResult first = deformed(mesh, list, options);
    const DeformResult second = deformed(test::renumbered(mesh, newIdOf), renamed, options);
    Positions back(mesh.vertexCount(), 3);
    for (Index v = 0; v < mesh.vertexCount(); ++v) back.row(v) = second.positions.row(newIdOf[v]);
    EXPECT_LT(distance(back, first.positions), kCommutes);
  });
}

TEST(DeformLaws, TwoRunsGiveTheSameBits)
{
  test::forEachSolveCase([](const Mesh& mesh, DeformOptions options) {
    for (const SolverKind kind : {SolverKind::Hard, SolverKind::Soft, SolverKind::Lagrange}) {
      options.solver.kind = kind;
      EXPECT_EQ(deformed(mesh, someMoves(mesh), options).positions, deformed(mesh, someMoves(mesh), options).positions)
          << name(kind);
    }
  });
}

TEST(DeformLaws, ASolverServesOtherTargetsAsAFreshOneWould)
{
  test::forEachSolveCase([](const Mesh& mesh, DeformOptions options) {
    const Triangulation triangulation = triangulate(mesh);
    const SolverMesh solverMesh = makeSolverMesh(mesh, triangulation);
    const auto A = std::make_shared<const EnergyMatrix>(weightedRows(makeOperators(solverMesh, options.weights)));
    const ConstraintSystem system =
        makeConstraintSystem(someMoves(mesh), mesh, solverMesh, SurfaceLocator(mesh, triangulation), "list");
    const auto eliminated = std::make_shared<const EliminatedConstraints>(eliminate(system, solverMesh));
    const Columns3 rest = solverMesh.rest.rowwise() - solverMesh.rest.colwise().mean();
    const Columns3 f = Columns3::Zero(rest.rows(), 3);
    for (const SolverKind kind : {SolverKind::Hard, SolverKind::Soft, SolverKind::Lagrange}) {
      options.solver.kind = kind;
      const SolverResult used = makeSolver({A, eliminated, rest}, options.solver);
      const SolverResult fresh = makeSolver({A, eliminated, rest}, options.solver);
      ASSERT_NE(used.value, nullptr) << used.failure;
      static_cast<void>(used.value->solve({-3 * shiftsOf(system), {}}, f));
      const RowTargets other{shiftsOf(system).reverse(), {}};
      EXPECT_EQ(used.value->solve(other, f).u, fresh.value->solve(other, f).u) << name(kind);
    }
  });
}

}  // namespace
}  // namespace holdfast
