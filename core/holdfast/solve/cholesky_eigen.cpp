// Cholesky factorisation of the normal equations by Eigen.

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {
namespace {

class CholeskyByEigen final : public LeastSquaresFactor {
 public:
  explicit CholeskyByEigen(const SparseMatrix& lower) : cholesky_(lower) {}

  [[nodiscard]] bool isRegular() const { return cholesky_.info() == Eigen::Success; }
  [[nodiscard]] Columns3 solve(const Columns3& g) const override { return cholesky_.solve(g); }
  [[nodiscard]] Index nonzeros() const override { return cholesky_.matrixL().nestedExpression().nonZeros(); }
  [[nodiscard]] std::string_view method() const override { return "Cholesky factor of the normal equations (Eigen)"; }

 private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> cholesky_;
};

}  // namespace

FactorResult choleskyByEigen(const LinearMap& C)
{
  const SparseMatrix lower = C.gramLower();
  auto factor = std::make_unique<CholeskyByEigen>(lower);
  if (factor->isRegular()) return {std::move(factor)};
  return {nullptr,
          fmt::format("the normal equations of {} unknowns are not positive definite in doubles", lower.cols())};
}

}  // namespace holdfast
