#include <vector>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <holdfast/elimination/sparse_qr.h>

#include "support/random.h"

namespace holdfast {
namespace {

struct Method {
  const char* name;
  SparseQrResult (*run)(const SparseMatrix&, double, WantQ, ColumnOrder);
};

void PrintTo(const Method& method, std::ostream* out)
{
  *out << method.name;
}

class SparseQr : public testing::TestWithParam<Method> {};

/// rows x cols with three entries a column; the last `copies` columns are combinations of two others.
SparseMatrix randomColumns(test::Random& random, Index rows, Index cols, Index copies)
{
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows, cols);
  for (Index c = 0; c < cols - copies; ++c)
    for (int k = 0; k < 3; ++k) dense(random.integer(0, rows - 1), c) += random.uniform(0.1, 1);
  for (Index c = cols - copies; c < cols; ++c)
    dense.col(c) =
        0.5 * dense.col(random.integer(0, cols - copies - 1)) + 0.25 * dense.col(random.integer(0, cols - copies - 1));
  return dense.sparseView();
}

SparseMatrix permuted(const SparseMatrix& M, const std::vector<Index>& columns)
{
  Eigen::MatrixXd result(M.rows(), M.cols());
  for (Index k = 0; k < M.cols(); ++k) result.col(k) = Eigen::MatrixXd(M).col(columns[k]);
  return result.sparseView();
}

TEST_P(SparseQr, FactorsMultiplyToTheMatrixAndQIsOrthonormal)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const ColumnOrder order = seed % 2 == 0 ? ColumnOrder::FillReducing : ColumnOrder::AsGiven;
    test::Random random(seed);
    const SparseMatrix M = randomColumns(random, 30, 14, 0);
    const SparseQrResult qr = GetParam().run(M, 1e-12, WantQ::Yes, order);
    const Eigen::MatrixXd Q = qr.Q.columnsFrom(0);
    ASSERT_EQ(Q.rows(), 30);
    ASSERT_EQ(Q.cols(), 30);
    EXPECT_LT((Q.transpose() * Q - Eigen::MatrixXd::Identity(30, 30)).norm(), 1e-13);
    EXPECT_LT((Q.leftCols(qr.rank) * Eigen::MatrixXd(qr.R) - Eigen::MatrixXd(permuted(M, qr.columns))).norm(), 1e-13);
  }
}

TEST_P(SparseQr, ReflectionsActAsTheMatrixTheyMake)
{
  test::Random random(3);
  const Reflections Q =
      GetParam().run(randomColumns(random, 30, 14, 3), 1e-12, WantQ::Yes, ColumnOrder::FillReducing).Q;
  const Eigen::MatrixXd whole = Q.columnsFrom(0);
  const Columns3 x = Columns3::Random(30, 3);
  EXPECT_LT((Q.times(x) - whole * x).norm(), 1e-13);
  EXPECT_LT((Q.transposeTimes(x) - whole.transpose() * x).norm(), 1e-13);
  EXPECT_EQ(Eigen::MatrixXd(Q.columnsFrom(17)), whole.rightCols(13));
}

TEST_P(SparseQr, DependentColumnsComeLastAndTheLeadingTriangleIsRegular)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const ColumnOrder order = seed % 2 == 0 ? ColumnOrder::FillReducing : ColumnOrder::AsGiven;
    test::Random random(seed);
    const SparseMatrix M = randomColumns(random, 60, 30, 6);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> pivoted(M.toDense());
    const Index rank = pivoted.setThreshold(1e-12).rank();
    const SparseQrResult qr = GetParam().run(M, 1e-12, WantQ::No, order);
    ASSERT_EQ(qr.rank, rank);
    ASSERT_EQ(qr.R.rows(), rank);
    ASSERT_EQ(qr.R.cols(), 30);
    const Eigen::MatrixXd R = qr.R;
    EXPECT_EQ(Eigen::MatrixXd(R.leftCols(rank).triangularView<Eigen::StrictlyLower>()).norm(), 0);
    EXPECT_GT(R.leftCols(rank).diagonal().cwiseAbs().minCoeff(), 1e-9);
    const Eigen::MatrixXd P = permuted(M, qr.columns);
    EXPECT_LT((R.transpose() * R - P.transpose() * P).norm(), 1e-12);
  }
}

std::vector<Method> methods()
{
  std::vector<Method> result{{"Eigen", sparseQrEigen}};
#ifdef HOLDFAST_WITH_CHOLMOD
  result.push_back({"SuiteSparse", sparseQrSuiteSparse});
#endif
  return result;
}

INSTANTIATE_TEST_SUITE_P(Methods, SparseQr, testing::ValuesIn(methods()),
                         [](const testing::TestParamInfo<Method>& method) { return method.param.name; });

}  // namespace
}  // namespace holdfast
