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
  explicit CholeskyByEigen(std::unique_ptr<Cholesky> cholesky) : cholesky_(std::move(cholesky)) {}

  [[nodiscard]] Columns3 solve(const Columns3& g) const override { return cholesky_->solve(g); }
  [[nodiscard]] Index nonzeros() const override { return cholesky_->matrixL().nestedExpression().nonZeros(); }
  [[nodiscard]] std::string_view method() const override { return "Cholesky factor of the normal equations (Eigen)"; }

 private:
  std::unique_ptr<Cholesky> cholesky_;
};

}  // namespace

FactorResult choleskyByEigen(const TwoWayMatrix& C)
{
  auto cholesky = std::make_unique<Cholesky>(gramLower(C));
  if (cholesky->info() != Eigen::Success)
    return {nullptr, fmt::format("the normal equations of {} unknowns are not positive definite in doubles",
                                 C.columns().cols())};
  return {std::make_unique<CholeskyByEigen>(std::move(cholesky)), {}};
}

}  // namespace holdfast
