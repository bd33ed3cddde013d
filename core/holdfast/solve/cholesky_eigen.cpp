// Cholesky factorisation of the normal equations by Eigen.

#include <utility>

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <holdfast/solve/gram.h>
#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {
namespace {

using Cholesky = Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>>;

class CholeskyByEigen final : public LeastSquaresFactor {
 public:
  CholeskyByEigen(std::shared_ptr<const SparseMatrix> C, std::unique_ptr<Cholesky> cholesky)
      : C_(std::move(C)), cholesky_(std::move(cholesky))
  {
  }

  [[nodiscard]] Columns3 solve(const Columns3& f) const override
  {
    return cholesky_->solve(Columns3(C_->transpose() * f));
  }
  [[nodiscard]] Index nonzeros() const override { return cholesky_->matrixL().nestedExpression().nonZeros(); }
  [[nodiscard]] std::string_view method() const override { return "Cholesky factor of the normal equations (Eigen)"; }

 private:
  std::shared_ptr<const SparseMatrix> C_;
  std::unique_ptr<Cholesky> cholesky_;
};

}  // namespace

FactorResult choleskyByEigen(std::shared_ptr<const SparseMatrix> C)
{
  auto cholesky = std::make_unique<Cholesky>(gramLower(*C));
  if (cholesky->info() != Eigen::Success)
    return {nullptr,
            fmt::format("the normal equations of {} unknowns are not positive definite in doubles", C->cols())};
  return {std::make_unique<CholeskyByEigen>(std::move(C), std::move(cholesky)), {}};
}

}  // namespace holdfast
