// Cholesky factorisation of the normal equations by our own multifrontal method.

#include <numeric>

#include <holdfast/factor/multifrontal.h>
#include <holdfast/factor/multipliers.h>
#include <holdfast/ordering/minimum_degree.h>
#include <holdfast/solve/interleaved_rows.h>
#include <holdfast/solve/least_squares_factor.h>
#include <holdfast/threads/long_step.h>

namespace holdfast {
namespace {

class CholeskyMultifrontal final : public LeastSquaresFactor {
 public:
  explicit CholeskyMultifrontal(std::unique_ptr<const PackedFactor> factor) : factor_(std::move(factor)) {}

  [[nodiscard]] Columns3 solve(const Columns3& g) const override
  {
    const std::vector<int>& order = factor_->symbolic().order;
    gather(order, g, x_);
    factor_->solveForward(x_);
    factor_->solveBackward(x_);
    Columns3 z(g.rows(), 3);
    scatter(order, x_, z);
    return z;
  }

  [[nodiscard]] const PackedFactor* packed() const override { return factor_.get(); }
  [[nodiscard]] Index nonzeros() const override { return factor_->symbolic().nonzeros(); }
  [[nodiscard]] std::string_view method() const override
  {
    return factor_->symbolic().hasMultipliers() ? "multifrontal factor of the normal equations and multipliers"
                                                : "multifrontal Cholesky factor of the normal equations";
  }

 private:
  std::unique_ptr<const PackedFactor> factor_;
  mutable std::vector<double> x_;  // memory that every solution uses again
};

/// The lower triangle of [M, K^T; K, 0] from that of M, whose columns are in this order.
SparseMatrix withKeptRows(const SparseMatrix& lower, const std::vector<int>& order, const SparseMatrix& K)
{
  const Index size = lower.cols();
  return assembled<SparseMatrix>(size + K.rows(), size + K.rows(), [&](Index k, ColumnSum& sum) {
    if (k >= size) return;
    sum.addColumn(lower, k);
    sum.addColumn(K, order[k], size);
  });
}

}  // namespace

FactorResult choleskyMultifrontal(const LinearMap& C, EliminationOrder wanted, const SparseMatrix& kept)
{
  const std::shared_ptr<const StepState> step = currentStep();
  step->stopIfLeftBehind();
  SparseMatrix lower = C.gramLower();
  step->stopIfLeftBehind();
  std::vector<int> order(static_cast<std::size_t>(lower.cols()));
  std::iota(order.begin(), order.end(), 0);
  if (wanted == EliminationOrder::ToBeFound) order = minimumDegreeOrder(lower);
  SymbolicFactor structure = analyze(lower, order);
  if (kept.rows() > 0) {
    lower = withKeptRows(lower, structure.order, kept);
    structure = withMultipliers(structure, lower);
  }
  const auto symbolic = std::make_shared<const SymbolicFactor>(std::move(structure));
  auto [factor, failure] = factorizeMultifrontal(symbolic, std::move(lower));
  if (factor == nullptr) return {nullptr, std::move(failure)};
  return {std::make_unique<CholeskyMultifrontal>(std::move(factor))};
}

}  // namespace holdfast
