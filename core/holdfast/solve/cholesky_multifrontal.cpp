// Cholesky factorisation of the normal equations by our own multifrontal method.

#include <numeric>

#include <holdfast/base/available_memory.h>
#include <holdfast/base/parallel.h>
#include <holdfast/factor/multifrontal.h>
#include <holdfast/factor/multipliers.h>
#include <holdfast/ordering/minimum_degree.h>
#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {
namespace {

class CholeskyMultifrontal final : public LeastSquaresFactor {
 public:
  explicit CholeskyMultifrontal(std::unique_ptr<const PackedFactor> factor) : factor_(std::move(factor)) {}

  [[nodiscard]] Columns3 solve(const Columns3& g) const override
  {
    factor_->gather(g, x_);
    factor_->solve(x_);
    return factor_->scattered(x_);
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

/// The lower triangle of [M, K^T; K, 0] from that of M: C^T C with columns in this order. K is the last `kept` rows of
/// C.
SparseMatrix withKeptRows(const SparseMatrix& lower, const std::vector<int>& order, const TwoWayMatrix& C, Index kept)
{
  const Index size = lower.cols();
  const Index firstKept = C.columns().rows() - kept;
  return assembled<SparseMatrix>(size + kept, size + kept, [&](Index k, ColumnSum& sum) {
    if (k >= size) return;
    sum.addColumn(lower, k);
    for (SparseMatrix::InnerIterator entry(C.columns(), order[k]); entry; ++entry)
      if (entry.row() >= firstKept) sum.add(static_cast<int>(size + entry.row() - firstKept), entry.value());
  });
}

}  // namespace

FactorResult choleskyMultifrontal(TwoWayMatrix& C, EliminationOrder wanted, Index kept)
{
  SparseMatrix lower = gramLower(C);
  const bool isShort = isLeastMemoryWanted();
  if (isShort) C.dropRows();  // not to be kept beside the numbers of fronts
  std::vector<int> order(static_cast<std::size_t>(lower.cols()));
  std::iota(order.begin(), order.end(), 0);
  if (wanted == EliminationOrder::ToBeFound) order = minimumDegreeOrder(lower);
  SymbolicFactor structure = analyze(lower, order);
  if (kept > 0) {
    lower = withKeptRows(lower, structure.order, C, kept);
    structure = withMultipliers(structure, lower);
  }
  const auto symbolic = std::make_shared<const SymbolicFactor>(std::move(structure));
  auto [factor, failure] = factorizeMultifrontal(symbolic, std::move(lower));
  if (isShort) C.makeRows();
  if (factor == nullptr) return {nullptr, std::move(failure)};
  return {std::make_unique<CholeskyMultifrontal>(std::move(factor))};
}

}  // namespace holdfast
