#include <array>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/deform/deformer.h>
#include <holdfast/solve/moved_solutions.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

constexpr Index kMovedUnknowns = 12;
constexpr Index kMovedRows = 5;

/// Any linear map from what rows ask for; counts its solutions.
class Linear final : public ConstrainedSolver {
 public:
  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    ++solutions;
    return {map_ * targets.shifts + f, 1, 1e-14};
  }
  [[nodiscard]] Displacement solveFrom(Displacement&& near, const RowTargets& targets, const Columns3& f) const override
  {
    Displacement result = solve(targets, f);
    farthest = (near.u - result.u).cwiseAbs().maxCoeff();
    return result;
  }
  [[nodiscard]] std::optional<Displacement> solveEdited(const Displacement& base, const RowTargets& targets,
                                                        const Columns3& f) const override
  {
    edited = base.u;
    return solve(targets, f);
  }
  [[nodiscard]] Index unknowns() const override { return kMovedUnknowns; }
  [[nodiscard]] Index factorNonzeros() const override { return 0; }
  [[nodiscard]] std::string method() const override { return "a product"; }

  mutable int solutions = 0;
  mutable double farthest = 0;  // of the last solution from where it began
  mutable Columns3 edited;      // the solution of another list from which the last one began

 private:
  Eigen::MatrixXd map_ = Eigen::MatrixXd::Random(kMovedUnknowns, kMovedRows);
};

class MovedRows : public testing::Test {
 protected:
  /// Solves again after the rows have moved by `by`; returns how many solutions that took.
  int move(const Columns3& by)
  {
    targets_.shifts += by;
    const int before = solver_.solutions;
    const SolvedDisplacement found = moved_.solve(solver_, targets_, q_, [this]() -> Columns3 { return 2 * q_; });
    const int taken = solver_.solutions - before;
    EXPECT_LT((found.displacement->u - solver_.solve(targets_, 2 * q_).u).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(*found.f, 2 * q_);
    return taken;
  }

  /// Row k moves by the k-th of these.
  static Columns3 rows(const std::array<double, kMovedRows>& x)
  {
    Columns3 by = Columns3::Zero(kMovedRows, 3);
    for (Index r = 0; r < kMovedRows; ++r) by.row(r) = x[r] * Vector3(1, -2, 0.5);
    return by;
  }

  Linear solver_;
  MovedSolutions moved_{makeModel(test::plate(3, 4)).solverMesh};
  RowTargets targets_{Columns3::Random(kMovedRows, 3), {}};
  Columns3 q_ = Columns3::Random(kMovedUnknowns, 3);
};

TEST_F(MovedRows, TakeOneSolutionForAllMovesOfADrag)
{
  EXPECT_EQ(move(Columns3::Zero(kMovedRows, 3)), 1);
  EXPECT_EQ(move(rows({0, 0.1, 0.1, 0, 0})), 1) << "how far these two reach";
  for (int k = 0; k < 10; ++k) EXPECT_EQ(move(rows({0, 0.1, 0.1, 0, 0})), 0) << k;
  EXPECT_EQ(move(rows({0, 1e-16, -1e-16, 0, 0})), 0) << "rounding";
}

TEST_F(MovedRows, AreAnsweredWhereTheyMoveByLittleMoreThanRounding)
{
  EXPECT_EQ(move(Columns3::Zero(kMovedRows, 3)), 1);
  EXPECT_EQ(move(rows({0, 2e-13, 0, 0, 0})), 1);
  EXPECT_EQ(move(rows({0, 2e-13, 2e-13, 0, 0})), 1) << "two groups: a move twice as far is no rounding of the other";
}

TEST_F(MovedRows, MayMoveInThreeWays)
{
  EXPECT_EQ(move(Columns3::Zero(kMovedRows, 3)), 1);
  EXPECT_EQ(move(rows({0.1, 0.2, 0.3, 0, 0})), 1);
  EXPECT_EQ(move(rows({0.2, 0.2, -0.3, 0, 0})), 1) << "other groups: the third is back";
  EXPECT_EQ(move(rows({0.1, 0.2, 0.3, 0.4, 0})), 1) << "four ways";
}

TEST_F(MovedRows, AreSolvedForAgainWhereAnythingElseHasChanged)
{
  EXPECT_EQ(move(Columns3::Zero(kMovedRows, 3)), 1);
  EXPECT_EQ(move(rows({0.1, 0, 0, 0, 0})), 1);
  q_(0, 0) += 0.1;
  EXPECT_EQ(move(rows({0.1, 0, 0, 0, 0})), 1) << "other rotations";
  targets_.reconciled = {4};
  EXPECT_EQ(move(rows({0.1, 0, 0, 0, 0})), 1) << "another redundant row";
  EXPECT_EQ(move(rows({1e6, 0, 0, 0, 0})), 1) << "so far that digits would be lost";
}

TEST_F(MovedRows, WithOtherRotationsBeginAtTheSumOfEarlierSolutionsThatIsNearest)
{
  std::vector<Columns3> turns;
  for (int k = 0; k < 3; ++k) turns.push_back(Columns3::Random(kMovedUnknowns, 3));
  const auto turnTo = [&](const Columns3& q, const Columns3& by) {
    q_ = q;
    EXPECT_EQ(move(by), 1);
    return solver_.farthest;
  };
  const Columns3 rest = Columns3::Zero(kMovedRows, 3);
  for (const Columns3& q : turns) turnTo(q, rest);
  EXPECT_LT(turnTo(2 * turns[0] - 3 * turns[1] + 2 * turns[2], rest), 1e-12);
  EXPECT_GT(turnTo(Columns3::Random(kMovedUnknowns, 3), rest), 0.1) << "nothing like any of them";
  EXPECT_LT(turnTo(q_ * 1.5, 0.5 * targets_.shifts), 1e-12) << "half as much more of all";
  targets_.reconciled = {4};
  solver_.farthest = -1;
  EXPECT_EQ(turnTo(q_ * 2, rest), -1) << "other rows are met: what was there is of no use";
}

TEST_F(MovedRows, OfAnEditedListBeginAtTheLastSolutionOfTheOneBefore)
{
  const SolverMesh mesh = makeModel(test::plate(3, 4)).solverMesh;
  int made = 0;
  const auto edit = [&] {
    made = 0;
    solver_.edited.resize(0, 3);
    MovedSolutions edited(mesh, moved_);
    const auto makeF = [&]() -> Columns3 { return ++made, 2 * q_; };
    const SolvedDisplacement found = edited.solve(solver_, targets_, q_, makeF);
    EXPECT_EQ(found.displacement->u, solver_.solve(targets_, 2 * q_).u);
    EXPECT_EQ(*found.f, 2 * q_);
    return solver_.edited;
  };
  move(Columns3::Zero(kMovedRows, 3));
  EXPECT_EQ(edit(), solver_.solve(targets_, 2 * q_).u);
  EXPECT_EQ(made, 0) << "f is as it was";
  move(rows({0.1, 0, 0, 0, 0}));
  EXPECT_LT((edit() - solver_.solve(targets_, 2 * q_).u).cwiseAbs().maxCoeff(), 1e-14) << "the sum, which is the last";
  q_(0, 0) += 0.1;
  EXPECT_EQ(edit().rows(), 0) << "f is another one";
  EXPECT_EQ(made, 1);
  moved_ = MovedSolutions(mesh);
  EXPECT_EQ(edit().rows(), 0) << "nothing was solved for";
}

/// A handle turns, in steps of a hand and far, beside points that stay.
struct Turn {
  Mesh mesh;
  int points;
  SolverKind kind;
};

class TurnOfAHandle : public testing::TestWithParam<Turn> {};

TEST_P(TurnOfAHandle, IsAsAccurateAsFreshDeformations)
{
  constexpr int kFrames = 20;
  const auto& [mesh, points, kind] = GetParam();
  const DeformOptions options{Weights::Cotangent, {kind, Backend::Holdfast, 100}};
  test::Random random(7);
  ConstraintList list = test::listOf({test::hold({0, 1, 2, 3})});
  const Index last = mesh.vertexCount() - 1;
  list.constraints.push_back({"handle", true, HandleConstraint{{VertexIds{{last, last - 10, last - 20}}}, {}, {}, {}}});
  for (int k = 0; k < points; ++k)
    list.constraints.push_back(test::moveBy(
        AtFace{static_cast<Index>(random.integer(0, static_cast<int>(mesh.faces.size()) - 1)), {0.25, 0.125, 0.625}},
        Vector3::Zero()));
  auto& handle = std::get<HandleConstraint>(list.constraints[1].what);
  Deformer deformer(makeModel(mesh), options, DeformerMode::Interactive);
  double degrees = 10;
  int corrections = 0;
  for (int k = 0; k < kFrames; ++k) {
    degrees += random.uniform(0.5, 1.5);
    if (k % 9 == 8) {
      degrees += 50;
      handle.translate.z() = random.uniform(-3, 3);
    }
    handle.motion = AxisRotation{Vector3(1, 1, 0), degrees, {}};
    const DeformResult result = deformer.deform(list);
    const DeformResult fresh = test::deformed(mesh, list, options);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LT(test::distance(result.positions, fresh.positions), 1e-12) << k;
    // Solutions with Lagrange multipliers are not corrected: they are as accurate as the library's LU.
    if (kind == SolverKind::Lagrange)
      EXPECT_EQ(result.report.solve.accuracy, fresh.report.solve.accuracy);
    else
      EXPECT_LT(result.report.solve.accuracy, 1e-9);
    corrections += result.report.solve.refinementSteps;
  }
  // The others correct as ever.
  const int most = kind == SolverKind::Hard ? kFrames / 2 : 2 * kFrames;
  EXPECT_LT(corrections, most) << "most frames need one solution";
}

// A long strip takes many digits; of 420 points some rows are kept in the system, with multipliers.
INSTANTIATE_TEST_SUITE_P(MovedSolutions, TurnOfAHandle,
                         testing::Values(Turn{test::plate(250, 4), 3, SolverKind::Hard},
                                         Turn{test::plate(250, 4), 3, SolverKind::Soft},
                                         Turn{test::plate(250, 4), 3, SolverKind::Lagrange},
                                         Turn{test::icosphere(3), 420, SolverKind::Hard}));

/// A drag of a point and of a handle, for each solver.
TEST(MovedSolutions, AreAsExactAsOthers)
{
  const Mesh mesh = test::plate(16, 12);
  for (const SolverKind kind : {SolverKind::Hard, SolverKind::Soft, SolverKind::Lagrange}) {
    const DeformOptions options{Weights::Cotangent, {kind, Backend::Holdfast, 100}};
    test::Random random(5);
    ConstraintList list = test::listOf({test::hold({0, 1, 2, 3})});
    const Index last = mesh.vertexCount() - 1;
    list.constraints.push_back(
        {"handle", true,
         HandleConstraint{
             {VertexIds{{last, last - 1, last - 2}}}, AxisRotation{Vector3(1, 1, 0), 40, {}}, Vector3::Zero(), {}}});
    list.constraints.push_back(test::moveBy(test::randomPlace(random, mesh), Vector3::Zero()));
    Deformer deformer(makeModel(mesh), options, DeformerMode::Interactive);
    for (int k = 0; k < 6; ++k) {
      std::get<HandleConstraint>(list.constraints[1].what).translate = 0.1 * k * Vector3(1, 2, 3);
      std::get<PointConstraint>(list.constraints[2].what).to = Move{0.05 * k * Vector3(0, 1, -1)};
      const DeformResult result = deformer.deform(list);
      const DeformResult fresh = test::deformed(mesh, list, options);
      EXPECT_EQ(result.report.solve.status, fresh.report.solve.status) << result.report.solve.message;
      EXPECT_LT(test::distance(result.positions, fresh.positions), 1e-11) << k;
      EXPECT_NEAR(result.report.solve.maxResidualRelative, fresh.report.solve.maxResidualRelative, 1e-12) << k;
    }
  }
}

}  // namespace
}  // namespace holdfast
