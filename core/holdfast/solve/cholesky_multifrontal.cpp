// Cholesky factorisation of the normal equations by our own multifrontal method.

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <holdfast/base/parallel.h>
#include <holdfast/factor/multifrontal.h>
#include <holdfast/solve/elimination_order.h>
#include <holdfast/solve/gram.h>
#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {
namespace {

class CholeskyMultifrontal final : public LeastSquaresFactor {
 public:
  explicit CholeskyMultifrontal(std::unique_ptr<const PackedFactor> factor) : factor_(std::move(factor)) {}

  [[nodiscard]] Columns3 solve(const Columns3& g) const override
  {
    const std::vector<int>& order = factor_->symbolic().order;
    const auto size = static_cast<Index>(order.size());
    x_.resize(4 * order.size());
    parallelBlocks(size, [&](Index k) { std::ranges::copy(g.row(order[k]), &x_[4 * k]); });
    factor_->solve(x_);
    Columns3 z(size, 3);
    parallelBlocks(size, [&](Index k) { z.row(order[k]) = Eigen::Map<const Eigen::RowVector3d>(&x_[4 * k]); });
    return z;
  }

  [[nodiscard]] Index nonzeros() const override { return factor_->symbolic().nonzeros(); }
  [[nodiscard]] std::string_view method() const override
  {
    return "multifrontal Cholesky factor of the normal equations";
  }

 private:
  std::unique_ptr<const PackedFactor> factor_;
  mutable std::vector<double> x_;  // memory that every solution uses again
};

}  // namespace

FactorResult choleskyMultifrontal(const TwoWayMatrix& C, EliminationOrder wanted)
{
  const SparseMatrix lower = gramLower(C);
  std::vector<int> order(static_cast<std::size_t>(lower.cols()));
  std::iota(order.begin(), order.end(), 0);
  if (wanted == EliminationOrder::ToBeFound) order = minimumDegreeOrder(lower);
  const auto symbolic = std::make_shared<const SymbolicFactor>(analyze(lower, order));
  auto [factor, failure] = factorizeMultifrontal(symbolic, lower);
  if (factor == nullptr) return {nullptr, std::move(failure)};
  return {std::make_unique<CholeskyMultifrontal>(std::move(factor))};
}

}  // namespace holdfast
