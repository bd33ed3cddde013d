#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/deform/model.h>
#include <holdfast/operators/operators.h>
#include <holdfast/ordering/elimination_order.h>
#include <holdfast/solve/constrained_solver.h>

#include "support/law_meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

/// A held strip, points inside faces, and a rigid region: columns of every kind.
ConstraintList someConstraints()
{
  ConstraintList list = test::listOf({test::hold({0, 1, 2, 3}), test::moveBy(AtFace{700, {0.2, 0.3, 0.5}}, {0, 0, 1}),
                                      test::moveBy(AtFace{701, {0.4, 0.3, 0.3}}, {0, 0, 1})});
  list.constraints.push_back({"rigid", true, RigidConstraint{{VertexIds{{500, 501, 502, 540}}}}});
  return list;
}

struct ReducedPlate {
  Model model = makeModel(test::plate(40, 30));
  std::shared_ptr<const EnergyMatrix> A =
      std::make_shared<const EnergyMatrix>(weightedRows(makeOperators(model.solverMesh, Weights::Cotangent)));
  ConstraintSystem system =
      makeConstraintSystem(someConstraints(), model.mesh, model.solverMesh, model.locator(), "list");
  EliminatedConstraints eliminated = eliminate(system, model.solverMesh);
  std::vector<int> ranks = eliminationRanks(model.solverMesh.unknownCount(), model.solverMesh.triangles);

  [[nodiscard]] std::unique_ptr<const ConstrainedSolver> solver(std::vector<int> its) const
  {
    return makeSolver(
               {A, std::make_shared<const EliminatedConstraints>(eliminated), model.solverMesh.rest, std::move(its)},
               {})
        .value;
  }
};

TEST(Ascending, KeepsTheOrderOfEqualKeys)
{
  EXPECT_EQ(ascending({3, 0, -1, 3, 1, 0, -1}, 4), (std::vector<int>{2, 6, 1, 5, 4, 0, 3}));
  EXPECT_TRUE(ascending({}, 0).empty());
}

TEST(EliminationOrder, RanksEachUnknownOnce)
{
  const ReducedPlate reduced;
  std::vector<int> sorted = reduced.ranks;
  std::ranges::sort(sorted);
  std::vector<int> all(static_cast<std::size_t>(reduced.model.solverMesh.unknownCount()));
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
}

TEST(EliminationOrder, PutsColumnsByTheLastOfTheirUnknowns)
{
  const ReducedPlate reduced;
  const SparseMatrix& Q2 = reduced.eliminated.elimination.Q2();
  const SparseMatrix ordered = orderedColumns(Q2, reduced.ranks);
  EXPECT_EQ(ordered.nonZeros(), Q2.nonZeros());
  int before = -1;
  for (Index k = 0; k < ordered.cols(); ++k) {
    int last = -1;
    for (SparseMatrix::InnerIterator entry(ordered, k); entry; ++entry)
      last = std::max(last, reduced.ranks[entry.row()]);
    EXPECT_GE(last, before);
    before = last;
  }
}

TEST(EliminationOrder, OfTheWholeMeshServesASetOfConstraintsAsWellAsOneOfItsOwn)
{
  const ReducedPlate reduced;
  const auto whole = reduced.solver(reduced.ranks);
  const auto own = reduced.solver({});
  ASSERT_NE(whole, nullptr);
  ASSERT_NE(own, nullptr);
  EXPECT_LT(static_cast<double>(whole->factorNonzeros()), 1.25 * static_cast<double>(own->factorNonzeros()));
  std::vector<int> byPlace(reduced.ranks.size());
  std::iota(byPlace.begin(), byPlace.end(), 0);
  EXPECT_GT(static_cast<double>(reduced.solver(byPlace)->factorNonzeros()),
            1.25 * static_cast<double>(own->factorNonzeros()))
      << "the measure tells orders apart";
  const RowTargets targets{shiftsOf(reduced.system), {}};
  const Columns3 f = Columns3::Zero(reduced.A->rows(), 3);
  EXPECT_LT((whole->solve(targets, f).u - own->solve(targets, f).u).cwiseAbs().maxCoeff(), 1e-11);
}

}  // namespace
}  // namespace holdfast
