// Cholesky factorisation of the normal equations by CHOLMOD, supernodal.

#include <mutex>
#include <new>

#include <fmt/format.h>

#include <holdfast/matrices/cholmod_view_internal.h>
#include <holdfast/solve/least_squares_factor.h>
#include <holdfast/threads/one_thread_internal.h>

namespace holdfast {
namespace {

/// METIS draws from the random numbers of the C library, which it starts anew for each order that it looks for: one at
/// a time, so that the order does not depend on what other threads do.
std::mutex& orderingLock()
{
  static std::mutex lock;
  return lock;
}

/// Owns CHOLMOD's workspace, its factor and the memory of both.
class CholeskyBySuiteSparse final : public LeastSquaresFactor {
 public:
  CholeskyBySuiteSparse()
  {
    cholmod_start(&common_);
    common_.print = 0;
    common_.supernodal = CHOLMOD_SUPERNODAL;
  }
  ~CholeskyBySuiteSparse() override
  {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  CholeskyBySuiteSparse(const CholeskyBySuiteSparse&) = delete;
  CholeskyBySuiteSparse& operator=(const CholeskyBySuiteSparse&) = delete;

  /// Analyses and factorises the matrix whose lower triangle is given; the reason where that fails.
  std::string factorize(SparseMatrix& lower)
  {
    const OneThread libraries;
    cholmod_sparse view = cholmodView(lower, StoredPart::LowerTriangle);
    {
      const std::scoped_lock lock(orderingLock());
      factor_ = cholmod_analyze(&view, &common_);
    }
    if (factor_ != nullptr) cholmod_factorize(&view, factor_, &common_);
    return failure(lower.rows());
  }

  [[nodiscard]] Columns3 solve(const Columns3& g) const override
  {
    const OneThread libraries;
    Eigen::MatrixX3d rightSides = g;
    cholmod_dense view{};
    view.nrow = static_cast<std::size_t>(rightSides.rows());
    view.ncol = 3;
    view.nzmax = view.nrow * view.ncol;
    view.d = view.nrow;
    view.x = rightSides.data();
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_, &view, &common_);
    if (solution == nullptr) throw std::bad_alloc();
    Columns3 result = Eigen::Map<const Eigen::MatrixX3d>(static_cast<const double*>(solution->x), rightSides.rows(), 3);
    cholmod_free_dense(&solution, &common_);
    return result;
  }

  [[nodiscard]] Index nonzeros() const override { return static_cast<Index>(common_.lnz); }
  [[nodiscard]] std::string_view method() const override { return "Cholesky factor of the normal equations (CHOLMOD)"; }

 private:
  [[nodiscard]] std::string failure(Index size) const
  {
    switch (common_.status) {
      case CHOLMOD_OK:
        return {};
      case CHOLMOD_NOT_POSDEF:
        return fmt::format("the normal equations are not positive definite in doubles (pivot {} of {})",
                           factor_ == nullptr ? 0 : factor_->minor + 1, size);
      case CHOLMOD_OUT_OF_MEMORY:
        return fmt::format("not enough memory to factorise {} unknowns", size);
      case CHOLMOD_TOO_LARGE:
        return fmt::format("the factor of {} unknowns is too large for 32-bit indices", size);
      default:
        return fmt::format("CHOLMOD failed with status {}", common_.status);
    }
  }

  mutable cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};

}  // namespace

FactorResult choleskyBySuiteSparse(const LinearMap& C)
{
  auto factor = std::make_unique<CholeskyBySuiteSparse>();
  SparseMatrix lower = C.gramLower();
  if (std::string failure = factor->factorize(lower); !failure.empty()) return {nullptr, std::move(failure)};
  return {std::move(factor)};
}

}  // namespace holdfast
