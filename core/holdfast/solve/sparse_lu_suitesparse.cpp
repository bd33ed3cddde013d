// LU by UMFPACK, through Eigen's wrapper.

#include <Eigen/UmfPackSupport>

#include <holdfast/base/one_thread_internal.h>
#include <holdfast/solve/sparse_lu.h>

namespace holdfast {
namespace {

class LuBySuiteSparse final : public SparseLu {
 public:
  explicit LuBySuiteSparse(const SparseMatrix& K) : K_(K)
  {
    const OneThread libraries;
    lu_.compute(K_);
  }

  [[nodiscard]] bool isRegular() const { return lu_.info() == Eigen::Success; }
  [[nodiscard]] Columns3 solve(const Columns3& rightSides) const override
  {
    const OneThread libraries;
    return Eigen::MatrixX3d(lu_.solve(Eigen::MatrixX3d(rightSides)));
  }
  [[nodiscard]] Index nonzeros() const override
  {
    int lower = 0;
    int upper = 0;
    int rows = 0;
    int columns = 0;
    int diagonal = 0;
    umfpack_di_get_lunz(&lower, &upper, &rows, &columns, &diagonal, lu_.numeric());
    return static_cast<Index>(lower) + upper;
  }

 private:
  /// Eigen keeps UMFPACK's object to itself.
  class Lu : public Eigen::UmfPackLU<SparseMatrix> {
   public:
    [[nodiscard]] void* numeric() const { return m_numeric; }
  };

  SparseMatrix K_;
  Lu lu_;
};

}  // namespace

std::unique_ptr<const SparseLu> luBySuiteSparse(const SparseMatrix& K)
{
  auto lu = std::make_unique<LuBySuiteSparse>(K);
  return lu->isRegular() ? std::move(lu) : nullptr;
}

}  // namespace holdfast
