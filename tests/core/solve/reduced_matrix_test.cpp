#include <gtest/gtest.h>

#include <holdfast/solve/reduced_matrix.h>

#include "support/random_sparse.h"

namespace holdfast {
namespace {

std::shared_ptr<const TwoWayMatrix> randomTwoWay(test::Random& random, Index rows, Index columns)
{
  return std::make_shared<const TwoWayMatrix>(test::randomSparse(random, rows, columns));
}

TEST(ReducedMatrix, IsTheProductWithRowsBelow)
{
  constexpr Index kEquations = 30;
  constexpr Index kPlaces = 20;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const auto A = std::make_shared<const EnergyMatrix>(test::randomSparse(random, kEquations, kPlaces));
    const auto Q2 = randomTwoWay(random, kPlaces, 12);
    for (const Index more : {0, 3}) {
      const SparseMatrix P = more == 0 ? SparseMatrix() : test::randomSparse(random, kPlaces, more);
      const SparseRows K = test::randomSparse(random, random.integer(1, 4), 12 + more);
      const ReducedMatrix C(A, Q2, P, K);

      Eigen::MatrixXd basis(kPlaces, 12 + more);
      basis.leftCols(12) = Eigen::MatrixXd(Q2->columns());
      if (more > 0) basis.rightCols(more) = Eigen::MatrixXd(P);
      Eigen::MatrixXd dense(kEquations + K.rows(), 12 + more);
      dense << Eigen::MatrixXd(A->matrix()) * basis, Eigen::MatrixXd(K);

      const Columns3 z = Columns3::Random(dense.cols(), 3);
      const Columns3 f = Columns3::Random(dense.rows(), 3);
      EXPECT_LT((C.spread(z) - basis * z).cwiseAbs().maxCoeff(), 1e-13);
      EXPECT_LT((C.times(z) - dense * z).cwiseAbs().maxCoeff(), 1e-13);
      EXPECT_LT((C.residual(f, z) - (f - dense * z)).cwiseAbs().maxCoeff(), 1e-13);
      EXPECT_LT((C.transposeTimes(f) - dense.transpose() * f).cwiseAbs().maxCoeff(), 1e-13);
      if (more > 0) continue;
      EXPECT_LT((Eigen::MatrixXd(C.matrix()->rows()) - dense).cwiseAbs().maxCoeff(), 1e-13);
      const Eigen::MatrixXd gram = (dense.transpose() * dense).triangularView<Eigen::Lower>();
      EXPECT_LT((Eigen::MatrixXd(C.gramLower()) - gram).cwiseAbs().maxCoeff(), 1e-13);
    }
  }
}

}  // namespace
}  // namespace holdfast
