// Cholesky factorisation of the normal equations by our own multifrontal method.

#include <utility>
#include <vector>

#include <Eigen/OrderingMethods>

#include <holdfast/base/parallel.h>
#include <holdfast/factor/multifrontal.h>
#include <holdfast/solve/gram.h>
#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {
namespace {

std::vector<int> minimumDegreeOrder(const SparseMatrix& lower)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().begin(), order.indices().end()};
}

class CholeskyMultifrontal final : public LeastSquaresFactor {
 public:
  CholeskyMultifrontal(std::shared_ptr<const SparseMatrix> C, std::unique_ptr<const PackedFactor> factor)
      : C_(std::move(C)), factor_(std::move(factor))
  {
  }

  [[nodiscard]] Columns3 solve(const Columns3& f) const override
  {
    const std::vector<int>& order = factor_->symbolic().order;
    const auto size = static_cast<Index>(order.size());
    std::vector<double> x(4 * order.size());
    parallelBlocks(size, [&](Index k) {
      Eigen::Map<Vector3> right(&x[4 * k]);
      right.setZero();
      for (SparseMatrix::InnerIterator entry(*C_, order[k]); entry; ++entry)
        right += entry.value() * f.row(entry.row()).transpose();
    });
    factor_->solve(x);
    Columns3 z(size, 3);
    parallelBlocks(size, [&](Index k) { z.row(order[k]) = Eigen::Map<const Eigen::RowVector3d>(&x[4 * k]); });
    return z;
  }

  [[nodiscard]] Index nonzeros() const override { return factor_->symbolic().nonzeros(); }
  [[nodiscard]] std::string_view method() const override
  {
    return "multifrontal Cholesky factor of the normal equations";
  }

 private:
  std::shared_ptr<const SparseMatrix> C_;
  std::unique_ptr<const PackedFactor> factor_;
};

}  // namespace

FactorResult choleskyMultifrontal(std::shared_ptr<const SparseMatrix> C)
{
  const SparseMatrix lower = gramLower(*C);
  const auto symbolic = std::make_shared<const SymbolicFactor>(analyze(lower, minimumDegreeOrder(lower)));
  auto [factor, failure] = factorizeMultifrontal(symbolic, lower);
  if (factor == nullptr) return {nullptr, std::move(failure)};
  return {std::make_unique<CholeskyMultifrontal>(std::move(C), std::move(factor))};
}

}  // namespace holdfast
