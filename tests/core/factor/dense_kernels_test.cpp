// Dense kernels of every processor that this one can stand in for, against their definitions.

#include <random>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <holdfast/factor/dense_kernels_internal.h>

namespace holdfast {
namespace {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// Narrower and wider than what registers and the blocks inside of Eigen hold.
constexpr int kSizes[] = {1, 2, 7, 8, 33, 64, 100, 192};
constexpr int kRows = 205;
constexpr double kUntouched = 77;
constexpr double kTolerance = 1e-12;

Eigen::MatrixXd randomMatrix(int rows, int columns)
{
  std::minstd_rand random(static_cast<unsigned>(rows + 1000 * columns));
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return static_cast<double>(random() % 2001) / 1000 - 1; });
}

LongMatrix lowerOf(const Eigen::MatrixXd& A)
{
  return LongMatrix(A.cast<long double>().triangularView<Eigen::Lower>());
}

class DenseKernelsTest : public testing::TestWithParam<const DenseKernels*> {};

INSTANTIATE_TEST_SUITE_P(Processors, DenseKernelsTest, testing::ValuesIn(runnableDenseKernels()));

TEST_P(DenseKernelsTest, CholeskyGivesTheMatrixBackAndLeavesWhatIsAboveTheDiagonal)
{
  for (const int n : kSizes) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Constant(kRows, n, kUntouched);
    const Eigen::MatrixXd half = randomMatrix(n, n);
    const Eigen::MatrixXd wanted = half * half.transpose() + n * Eigen::MatrixXd::Identity(n, n);
    A.topRows(n).triangularView<Eigen::Lower>() = wanted;
    ASSERT_EQ(GetParam()->cholesky(n, A.data(), kRows), 0);
    const LongMatrix L = lowerOf(A.topRows(n));
    EXPECT_LE((L * L.transpose() - wanted.cast<long double>()).cwiseAbs().maxCoeff(), kTolerance * n) << n;
    for (int j = 0; j < n; ++j) {
      EXPECT_TRUE((A.col(j).head(j).array() == kUntouched).all()) << n;
      EXPECT_TRUE((A.col(j).tail(kRows - n).array() == kUntouched).all()) << n;
    }
  }
}

TEST_P(DenseKernelsTest, CholeskySaysWhereAPivotIsNotPositive)
{
  for (const int n : kSizes)
    for (const int bad : {0, n / 2, n - 1}) {
      Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n);
      A(bad, bad) = -1;
      EXPECT_EQ(GetParam()->cholesky(n, A.data(), n), bad + 1) << n;
    }
}

TEST_P(DenseKernelsTest, SolvesGiveTheRightHandSideBack)
{
  for (const int n : kSizes)
    for (const int m : kSizes) {
      Eigen::MatrixXd L = randomMatrix(n, n) / n;
      L.diagonal().array() += 2;
      const Eigen::MatrixXd wanted = randomMatrix(m, n);
      Eigen::MatrixXd B = Eigen::MatrixXd::Constant(kRows, n, kUntouched);
      B.topRows(m) = wanted;
      GetParam()->solveRight(m, n, L.data(), n, B.data(), kRows);
      const LongMatrix back = B.topRows(m).cast<long double>() * lowerOf(L).transpose();
      EXPECT_LE((back - wanted.cast<long double>()).cwiseAbs().maxCoeff(), kTolerance) << m << " x " << n;
      EXPECT_TRUE((B.bottomRows(kRows - m).array() == kUntouched).all()) << m << " x " << n;
    }
}

TEST_P(DenseKernelsTest, UpdatesAreProducts)
{
  for (const int n : kSizes)
    for (const int k : kSizes)
      for (const double scale : {0.0, 1.0})
        for (const double factor : {1.0, -1.0}) {
          const Eigen::MatrixXd A = randomMatrix(kRows, k);
          Eigen::MatrixXd symmetric = Eigen::MatrixXd::Constant(kRows, n, kUntouched);
          Eigen::MatrixXd whole = symmetric;
          GetParam()->symmetricUpdate(n, k, factor, A.data() + 1, kRows, scale, symmetric.data(), kRows);
          constexpr int m = 9;
          GetParam()->update(m, n, k, factor, A.data() + 2, A.data() + 1, kRows, scale, whole.data(), kRows);

          const LongMatrix left = A.cast<long double>();
          const auto product = [&](int i, int j) { return left.row(i).dot(left.row(j)); };
          for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
              const auto wanted = i < j ? kUntouched : scale * kUntouched + factor * product(1 + i, 1 + j);
              ASSERT_NEAR(symmetric(i, j), static_cast<double>(wanted), kTolerance * (1 + k)) << n << ' ' << k;
            }
            for (int i = 0; i < m; ++i)
              ASSERT_NEAR(whole(i, j), static_cast<double>(scale * kUntouched + factor * product(2 + i, 1 + j)),
                          kTolerance * (1 + k))
                  << n << ' ' << k;
            ASSERT_EQ(whole(m, j), kUntouched);
          }
        }
}

}  // namespace
}  // namespace holdfast
