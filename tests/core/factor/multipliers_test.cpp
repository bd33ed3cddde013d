#include <algorithm>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <holdfast/factor/multifrontal.h>
#include <holdfast/factor/multipliers.h>

#include "core/factor/spd_matrices.h"

namespace holdfast {
namespace {

/// [M, K^T; K, 0] and the structure of its factor.
struct Saddle {
  SparseMatrix matrix;
  SparseMatrix lower;  // in the order of elimination
  std::shared_ptr<const SymbolicFactor> symbolic;

  Saddle(const SparseMatrix& M, const SparseMatrix& K)
  {
    const Index n = M.cols();
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + K.rows(), n + K.rows());
    whole.topLeftCorner(n, n) = M;
    whole.bottomLeftCorner(K.rows(), n) = K;
    whole.topRightCorner(n, K.rows()) = K.transpose();
    matrix = whole.sparseView();
    const test::Analysis ofM(M);
    std::vector<int> order = ofM.symbolic->order;
    for (Index r = 0; r < K.rows(); ++r) order.push_back(static_cast<int>(n + r));
    lower = inOrder(test::lowerOf(matrix), order);
    symbolic = std::make_shared<const SymbolicFactor>(withMultipliers(*ofM.symbolic, lower));
  }

  [[nodiscard]] auto factorized() const { return factorizeMultifrontal(symbolic, lower); }
};

/// Each row ties three neighbours in a chain of columns, every other column at most in several rows.
SparseMatrix chainRows(test::Random& random, Index rows, Index columns)
{
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(rows, columns);
  for (Index r = 0; r < rows; ++r) {
    const Index first = r * (columns - 3) / std::max<Index>(1, rows - 1);
    for (Index k = 0; k < 3; ++k) K(r, first + k) = random.uniform(0.05, 1);
  }
  return K.sparseView();
}

TEST(Multipliers, SolveAsDenseEliminationDoes)
{
  test::Random random(11);
  for (int turn = 0; turn < 40; ++turn) {
    const Index n = random.integer(4, 200);
    const SparseMatrix K = chainRows(random, random.integer(1, n / 2), n);
    const SparseMatrix M = SparseMatrix(test::randomSpd(random, n, 3) + K.transpose() * K);
    const Saddle saddle(M, K);
    const auto result = saddle.factorized();
    ASSERT_TRUE(result) << result.failure;
    const Columns3 expected = Columns3::Random(n + K.rows(), 3);
    const Columns3 found = test::solved(*result.value, saddle.matrix * expected);
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(Multipliers, ColumnsWithFewEntriesAreSolvedForwardAlone)
{
  test::Random random(13);
  for (int turn = 0; turn < 20; ++turn) {
    const Index n = random.integer(4, 200);
    const SparseMatrix K = chainRows(random, random.integer(0, n / 2), n);
    const Saddle saddle(SparseMatrix(test::randomSpd(random, n, 3) + K.transpose() * K), K);
    const auto result = saddle.factorized();
    ASSERT_TRUE(result) << result.failure;
    SparseMatrix b(saddle.matrix.rows(), random.integer(0, 11));
    for (Index k = 0; k < 2 * b.cols(); ++k)
      b.coeffRef(random.integer(0, b.rows() - 1), k % b.cols()) = random.uniform(-1, 1);
    const Eigen::MatrixXd V = result.value->solveForward(b);
    Eigen::VectorXd signs = Eigen::VectorXd::Ones(b.rows());
    for (const int column : result.value->negative()) signs(column) = -1;
    EXPECT_EQ((signs.array() < 0).count(), K.rows());
    // b^T M^-1 b = V^T S V.
    const Eigen::MatrixXd expected =
        Eigen::MatrixXd(b).transpose() * Eigen::MatrixXd(saddle.matrix).partialPivLu().solve(Eigen::MatrixXd(b));
    EXPECT_LT((V.transpose() * signs.asDiagonal() * V - expected).norm(), 1e-9);
  }
}

TEST(Multipliers, MayBeAllThatMakesTheMatrixRegular)
{
  // Without the rows a common shift of all columns costs nothing.
  test::Random random(12);
  SparseMatrix M = test::gridMatrix(6);
  const Index n = M.cols();
  for (Index i = 0; i < n; ++i) M.coeffRef(i, i) -= M.col(i).sum();
  const SparseMatrix K = chainRows(random, 40, n);
  const Saddle saddle(SparseMatrix(M + K.transpose() * K), K);
  const auto result = saddle.factorized();
  ASSERT_TRUE(result) << result.failure;
  const Columns3 b = Columns3::Random(n + K.rows(), 3);
  const Columns3 x = test::solved(*result.value, b);
  EXPECT_LT((saddle.matrix * x - b).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Multipliers, HaveNegativePivotsAndComeAfterTheColumnsTheyAreMatchedWith)
{
  test::Random random(13);
  const SparseMatrix K = chainRows(random, 30, 90);
  const Saddle saddle(SparseMatrix(test::randomSpd(random, 90, 3) + K.transpose() * K), K);
  int multipliers = 0;
  for (const Supernode& node : saddle.symbolic->supernodes) {
    multipliers += node.multipliers;
    EXPECT_LT(node.multipliers, node.width);
    for (int k = 0; k < node.width; ++k)
      EXPECT_EQ(saddle.symbolic->order[node.firstColumn + k] >= 90, k >= node.width - node.multipliers);
  }
  EXPECT_EQ(multipliers, 30);
}

/// Rows in pairs of which the second differs from a multiple of the first in one or two entries far from the others, so
/// that leading parts of the pair are dependent.
SparseMatrix pairedRows(test::Random& random, Index pairs, Index columns)
{
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * pairs, columns);
  for (Index p = 0; p < pairs; ++p) {
    for (int k = 0; k < 3; ++k) K(2 * p, random.integer(0, columns - 1)) = random.uniform(0.3, 1);
    K.row(2 * p + 1) = random.uniform(0.5, 1) * K.row(2 * p);
    for (int k = 0; k < 2; ++k) K(2 * p + 1, random.integer(0, columns - 1)) += random.uniform(0.3, 1);
  }
  return K.sparseView();
}

/// How nearly dependent rows of K are, whose multipliers are in a leading part of whole supernodes, on the columns that
/// are in it: the least pivot of a QR, over all such parts.
double leastOfLeadingParts(const SymbolicFactor& symbolic, const Eigen::MatrixXd& K)
{
  double least = 1;
  std::vector<Index> columns;
  std::vector<Index> rows;
  for (const Supernode& node : symbolic.supernodes) {
    for (int k = node.firstColumn; k < node.end(); ++k) {
      const Index column = symbolic.order[k];
      column < K.cols() ? columns.push_back(column) : rows.push_back(column - K.cols());
    }
    if (rows.empty() || node.multipliers == 0) continue;
    const Eigen::MatrixXd part = K(rows, columns);
    if (part.rows() > part.cols()) return 0;
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(part.transpose());
    least = std::min(least, qr.matrixR().diagonal().cwiseAbs().minCoeff());
  }
  return least;
}

TEST(Multipliers, OfALeadingPartHaveIndependentRowsOnTheColumnsInIt)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    test::Random random(seed);
    const Index n = random.integer(80, 160);
    const SparseMatrix K = pairedRows(random, n / 8, n);
    if (Eigen::MatrixXd(K).colPivHouseholderQr().rank() < K.rows()) continue;
    const Saddle saddle(SparseMatrix(test::randomSpd(random, n, 2) + K.transpose() * K), K);
    EXPECT_GT(leastOfLeadingParts(*saddle.symbolic, K), 1e-6);
    EXPECT_TRUE(saddle.factorized());
  }
}

}  // namespace
}  // namespace holdfast
